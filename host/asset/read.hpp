#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "asset/model.hpp"

namespace aerostat::asset {

/// The most that is read of a model. All of it is checked before memory is taken. With these
/// defaults, the largest model takes a few GiB of memory.
struct Limits {
  std::uint64_t file_bytes = std::uint64_t{1} << 30;     // of each file, also of those referred to
  std::size_t vertices = 20'000'000;                     // in all meshes
  std::size_t triangles = 20'000'000;                    // in all meshes
  std::uint64_t texture_side = 16'384;                   // pixels along an edge
  std::uint64_t texture_bytes = std::uint64_t{1} << 30;  // of all textures, 4 bytes a pixel
  std::size_t nodes = 200'000;
  std::size_t node_depth = 256;  // levels of nodes
  std::size_t placements = 1'000'000;
  std::size_t materials = 10'000;
};

enum class Axis { y, z };
enum class Format { gltf, obj, ply, stl };

/// What a user may say about a file.
struct ReadOptions {
  /// The axis of the file that points up. glTF says y; files of the other formats do not say it.
  Axis up = Axis::y;
  /// The folder that all files which a model refers to must lie in, after symbolic links are
  /// followed. By default it is the folder of the model.
  std::optional<std::filesystem::path> folder;
  /// Files may refer to others anywhere.
  bool allow_external = false;
  Limits limits = {};
};

/// Returns the format of a model by the beginning of its content and the name of the file, or
/// nothing if it is none of them.
std::optional<Format> format_of(std::string_view beginning, const std::filesystem::path& file);

/// Reads a model. Throws Error{io} if the file cannot be read, and Error{bad_data} if it cannot be
/// used. The message names the file and the place in it (a JSON pointer, a line, or a byte) and
/// says what was found and what was expected.
Model read(const std::filesystem::path& file, const ReadOptions& options = {});

/// Reads a model whose file is in memory. `file` is its name for messages, and what it refers to is
/// looked for beside it. Throws what `read` throws.
Model read_bytes(std::string_view bytes, Format format, const std::filesystem::path& file,
                 const ReadOptions& options = {});

}  // namespace aerostat::asset
