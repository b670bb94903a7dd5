#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "asset/gltf_accessors.hpp"
#include "asset/gltf_materials.hpp"
#include "asset/json_value.hpp"
#include "asset/reading.hpp"

namespace aerostat::asset {

/// The joints that move a vertex, by their places in a skin, and how much.
struct GltfInfluence {
  std::array<std::uint32_t, 4> joints{};
  glm::vec4 weights{0.0f};
};

/// What moves the vertices of a primitive: as many influences for each of them as the file has
/// sets.
struct GltfInfluences {
  std::size_t sets = 0;
  std::vector<GltfInfluence> of_vertices;  // `sets` for each vertex
};

/// A mesh and, for each primitive of it, what moves its vertices.
struct GltfMesh {
  Mesh mesh;
  std::vector<GltfInfluences> influences;
};

/// Reads the meshes of a glTF file. Throws Error{bad_data} for an attribute that cannot be
/// understood or an index that is out of range. Points and lines are left out, and a note says so.
std::vector<GltfMesh> read_gltf_meshes(const JsonValue& root, const GltfAccessors& accessors,
                                       const GltfMaterials& materials, Reading& reading);

/// Returns a copy of a mesh whose vertices are moved by the joints of a skin. `joints` has, for
/// each joint of the skin, the matrix from the mesh to the scene. Throws Error{bad_data} if a
/// vertex names another joint; `skin` is where the skin stands.
Mesh skinned(const GltfMesh& mesh, const std::vector<glm::dmat4>& joints, const JsonValue& skin);

}  // namespace aerostat::asset
