#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "render/session.hpp"

/// These functions turn the words of the command line into values.
namespace aerostat::cli {

/// Returns the part of a picture that "x0,y0,x1,y1" names: the pixels with x0 <= x < x1 and y0 <=
/// y < y1. Throws Error{usage} if the text is not four whole numbers >= 0 or if the part is
/// empty.
render::Crop parse_crop(const std::string& text);

/// Throws Error{usage} if the crop extends beyond the image.
void require_inside(const render::Crop& crop, int width, int height);

/// Returns the bytes of a size such as "1500000", "512M", "2G" or "1.5GiB". K, M, G and T are
/// powers of 1024. Throws Error{usage} if the text is not a size. A fraction of bytes, such as
/// "1.5", is refused too, because a unit was probably forgotten.
std::uint64_t parse_byte_size(const std::string& text);

/// Returns the seconds of a time such as "90", "90s", "10m" or "1.5h". Throws Error{usage} if the
/// text is no time above 0. The message names the option.
double parse_duration(const std::string& text, const char* option = "--time-limit");

inline constexpr int kMostTiles = 1000;

/// Returns the seeds of a list such as "1-12", "7" or "1,5,9-11", in the order of the list. Seeds
/// are whole numbers from 0 to 4294967295. Throws Error{usage} if the text is not such a list or
/// has more than kMostTiles seeds.
std::vector<std::uint32_t> parse_seeds(const std::string& text);

enum class PictureFormat { png, exr, geotiff };

/// Returns the format that `format`, "png", "exr" or "tif", names. If `format` is empty, the
/// extension of the file decides, in upper or lower case. Standard output, and a special file (see
/// is_special_file) without an extension, get PNG. Throws Error{usage} for any extension but .png,
/// .exr, .tif and .tiff.
PictureFormat picture_format(const std::filesystem::path& path, const std::string& format = {});

enum class MeshFormat { ply, obj, glb, gltf };

/// Returns the format that `format`, such as "ply", names. If `format` is empty, the extension
/// of the file decides, in upper or lower case. Standard output, and a special file (see
/// is_special_file) without an extension, get PLY. Throws Error{usage} for any extension but .ply,
/// .obj, .glb and .gltf.
MeshFormat mesh_format(const std::filesystem::path& path, const std::string& format = {});

/// Returns whether a name on the command line is "-". It stands for standard input where a scene
/// is read, and for standard output where a file is written.
bool is_standard(const std::filesystem::path& path);

/// Returns the scene's name with `ending`, in the current folder. Throws Error{usage} for a scene
/// from standard input, which has no name.
std::filesystem::path default_picture(const std::filesystem::path& scene,
                                      const char* ending = ".png");

}  // namespace aerostat::cli
