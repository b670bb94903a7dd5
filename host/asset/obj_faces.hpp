#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "asset/reading.hpp"

namespace aerostat::asset {

/// The vertices of an OBJ file, as its lines list them.
struct ObjVertices {
  std::vector<glm::dvec3> points;
  std::vector<glm::vec4> colors;  // linear; empty, or one for each point
  std::vector<glm::vec2> uv;      // v counts from the bottom row
  std::vector<glm::vec3> normals;
};

/// Stands for a corner that has no texture coordinates or no normal.
inline constexpr std::uint32_t kNoIndex = 0xffffffff;

/// The corner of a face: where its position, its texture coordinates and its normal stand in the
/// lists, from 0.
struct ObjCorner {
  std::uint32_t point = 0, uv = kNoIndex, normal = kNoIndex;

  auto operator<=>(const ObjCorner&) const = default;
};

/// Faces of one material that have the same attributes.
struct ObjFaces {
  std::vector<ObjCorner> corners;    // of all faces, one behind the other
  std::vector<std::uint32_t> sizes;  // of the faces
  std::vector<std::uint32_t> lines;  // that the faces stand on
};

/// What faces must share to be drawn together.
struct ObjKey {
  std::string material;
  bool has_uv = false, has_normals = false, is_smooth = false;

  auto operator<=>(const ObjKey&) const = default;
};

/// Returns the triangles of faces around the origin of the model, without a material. `scale` and
/// `offset` change the texture coordinates, and `positions` are those of `vertices.points`. Throws
/// Error{bad_data} with the line if a face names what is not there.
Primitive primitive_of(const ObjFaces& faces, const ObjKey& key, const ObjVertices& vertices,
                       const std::vector<glm::vec3>& positions, glm::vec2 scale, glm::vec2 offset,
                       Budget& budget);

}  // namespace aerostat::asset
