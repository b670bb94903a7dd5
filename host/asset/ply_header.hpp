#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aerostat::asset {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t bytes_of(PlyType type);
bool is_whole(PlyType type);

/// A number, or a list of numbers, of each element of a kind.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type;  // of a list: the type of its length
};

/// A kind of elements, such as "vertex" or "face".
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

/// The header of a PLY file: what its body holds, and in which form.
struct PlyHeader {
  bool is_text = false;
  std::endian order = std::endian::little;  // of the bytes of numbers
  std::vector<PlyElement> elements;
  std::string texture_file;   // that MeshLab names in a comment
  std::size_t bytes = 0;      // of the header
  std::size_t last_line = 0;  // of the header
};

/// Reads the header of a PLY file. Throws Error{bad_data} with the line.
PlyHeader read_ply_header(std::string_view bytes);

}  // namespace aerostat::asset
