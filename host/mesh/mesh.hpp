#pragma once

#include <cstddef>
#include <vector>

#include "core/math.hpp"

namespace aerostat::mesh {

/// An indexed triangle mesh in metres, right-handed, y up; front faces wind counter-clockwise.
/// `normals` (unit) has one entry per position. `colors` (linear Rec. 709 albedo) has one entry
/// per position or is empty, which means white. `places` are coordinates on the surface, by which a
/// look that is finer than the triangles is laid out; one per position or none, which means that
/// there is no such look. A sharp edge or a change of colour has its vertices twice.
struct TriangleMesh {
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  std::vector<vec3> colors;
  std::vector<vec2> places;
  std::vector<uvec3> triangles;

  bool empty() const { return triangles.empty(); }
};

/// Appends `part` to `whole`; where only one of them has colours or places, white and 0 are
/// filled in.
void append(TriangleMesh& whole, const TriangleMesh& part);

/// Area-weighted vertex normals from the triangles, replacing what was there. Vertices that no
/// triangle of positive area uses get +y.
void compute_normals(TriangleMesh& mesh);

/// Throws Error{internal} if an index is out of range or an attribute's length is wrong.
void check(const TriangleMesh& mesh, const char* name);

}  // namespace aerostat::mesh
