#pragma once

#include <optional>
#include <string_view>

#include "asset/json_value.hpp"

namespace aerostat::asset {

/// The parts of a glTF file: its JSON and, in a .glb, the binary piece behind it.
struct GltfFile {
  Json json;
  std::optional<std::string_view> binary;
};

/// Takes a .gltf or .glb apart. Throws Error{bad_data} with a byte, or with the line and column of
/// the JSON.
GltfFile open_gltf(std::string_view bytes);

/// Throws Error{bad_data} unless the file has version 2 and requires only extensions that are read.
/// Returns the names of those that it uses and that are left out.
std::vector<std::string> check_gltf(const JsonValue& root);

}  // namespace aerostat::asset
