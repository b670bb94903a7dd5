#pragma once

#include <vector>

#include "mesh/grid_mesh.hpp"

namespace aerostat::scatter {

/// A point of the ground as it is rendered.
struct SurfacePoint {
  vec3 position{0.0f};
  vec3 normal{0.0f, 1.0f, 0.0f};  // unit, interpolated as in shading
};

/// The ground's mesh as a function of the place; `ground` must outlive this.
class Surface {
 public:
  explicit Surface(const mesh::GridMesh& ground);

  /// The point of the triangle over or under (x, z); outside the mesh its rim goes on level.
  SurfacePoint at(double x, double z) const;
  bool covers(double x, double z) const;
  float height(double x, double z) const { return at(x, z).position.y; }

 private:
  const mesh::GridMesh& ground_;
  std::vector<float> x_, z_;  // the grid's lines
};

}  // namespace aerostat::scatter
