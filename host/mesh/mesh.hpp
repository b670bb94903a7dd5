#pragma once

#include <cstddef>
#include <vector>

#include "core/math.hpp"

namespace aerostat::mesh {

/// An indexed triangle mesh in metres, right-handed, with y up. Front faces wind
/// counter-clockwise. `normals` has one unit vector for each position. `colors` has one linear
/// Rec. 709 albedo for each position, or is empty, which means white. `uvs` has texture
/// coordinates for detail that is finer than the triangles: one pair for each position, or none if
/// there is no such detail. The vertices along a sharp edge or a change of colour exist twice.
struct TriangleMesh {
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  std::vector<vec3> colors;
  std::vector<vec2> uvs;
  std::vector<uvec3> triangles;

  bool empty() const { return triangles.empty(); }
};

/// Appends `part` to `whole`. If only one of them has colours or uvs, the other one gets white or
/// 0.
void append(TriangleMesh& whole, const TriangleMesh& part);

/// Computes area-weighted vertex normals from the triangles and replaces the old normals.
/// Vertices without a triangle of positive area get +y.
void compute_normals(TriangleMesh& mesh);

/// Checks a mesh. Throws Error{internal}, with `name`, if an index is out of range or if the
/// length of an attribute is wrong.
void check(const TriangleMesh& mesh, const char* name);

}  // namespace aerostat::mesh
