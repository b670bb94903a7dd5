#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "render/session.hpp"

/// From the words of the command line to values.
namespace aerostat::cli {

/// "x0,y0,x1,y1": pixels x0 <= x < x1, y0 <= y < y1. Throws Error{usage} if it is not four whole
/// numbers >= 0 or the part is empty.
render::Crop parse_crop(const std::string& text);

/// Throws Error{usage} if the crop leaves the image.
void require_inside(const render::Crop& crop, int width, int height);

/// "1500000", "512M", "2G", "1.5GiB": bytes; K, M, G and T are powers of 1024. Throws Error{usage},
/// also for parts of bytes, such as "1.5", which is likely to be a unit forgotten.
std::uint64_t parse_byte_size(const std::string& text);

inline constexpr int kMostTiles = 1000;

/// "1-12", "7", "1,5,9-11": whole numbers from 0 to 4294967295 and ranges of them, in their order,
/// at most kMostTiles. Throws Error{usage}.
std::vector<std::uint32_t> parse_seeds(const std::string& text);

enum class PictureFormat { png, exr };

/// "png" or "exr", or if that is empty by the file's extension, whatever its case; PNG for standard
/// output and, without an extension, for a special file (see is_special_file). Throws Error{usage}
/// for any extension but .png and .exr.
PictureFormat picture_format(const std::filesystem::path& path, const std::string& format = {});

enum class MeshFormat { ply, obj };

/// "ply" or "obj", or if that is empty by the file's extension, whatever its case; PLY for standard
/// output and such a special file. Throws Error{usage} for any extension but .ply and .obj.
MeshFormat mesh_format(const std::filesystem::path& path, const std::string& format = {});

/// Whether a name on the command line is "-": standard input of a scene, standard output of a file.
bool is_standard(const std::filesystem::path& path);

/// The scene's name with `ending`, in the current folder. Throws Error{usage} for a scene from
/// standard input, which has no name.
std::filesystem::path default_picture(const std::filesystem::path& scene,
                                      const char* ending = ".png");

}  // namespace aerostat::cli
