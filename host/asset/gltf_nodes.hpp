#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "asset/json_value.hpp"
#include "asset/reading.hpp"

namespace aerostat::asset {

/// A node of a glTF file.
struct GltfNode {
  glm::dmat4 global{1.0};  // from the node to the scene
  std::optional<std::size_t> parent;
  bool is_shown = false;  // it belongs to the scene that is read
};

/// Returns translation times rotation, a quaternion (x, y, z, w) of any length, times scale.
glm::dmat4 composed(const glm::dvec3& translation, const glm::dvec4& rotation,
                    const glm::dvec3& scale);

/// Reads the nodes of a file and which of them the default scene shows. Throws Error{bad_data}
/// unless they are trees.
std::vector<GltfNode> read_gltf_nodes(const JsonValue& root, Budget& budget);

}  // namespace aerostat::asset
