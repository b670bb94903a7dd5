#pragma once

#include <vector>

#include "mesh/grid_mesh.hpp"

namespace aerostat::scatter {

/// A point of the ground as it is rendered.
struct SurfacePoint {
  vec3 position{0.0f};
  /// The unit normal, interpolated as in shading.
  vec3 normal{0.0f, 1.0f, 0.0f};
};

/// Ascending lines with an index that finds the cell of a value in one or two steps.
class Lines {
 public:
  void add(float line) { lines_.push_back(line); }
  /// Builds the index. Call it when all lines are added, which must be at least two.
  void index();

  /// The cell of a value and the share of the cell up to it, from 0 to 1. A value beyond all lines
  /// has the first or the last cell.
  struct Place {
    std::uint32_t cell;
    float share;
  };
  Place at(double value) const;
  bool cover(double value) const {
    return value >= static_cast<double>(lines_.front()) &&
           value <= static_cast<double>(lines_.back());
  }

 private:
  std::vector<float> lines_;
  /// For each of several even parts, the cell that holds its lower end.
  std::vector<std::uint32_t> first_;
  double parts_per_m_ = 0.0;
};

/// The mesh of the ground as a function of the place. `ground` must outlive this object.
class Surface {
 public:
  /// Makes the surface of a ground. `origin` is the place over the terrain of the point from which
  /// the ground counts. All other functions take places over the terrain in metres.
  explicit Surface(const mesh::GridMesh& ground, const dvec3& origin = dvec3(0.0));

  /// Returns the point of the triangle over or under (x, z). Outside the mesh, its rim continues
  /// level.
  SurfacePoint at(double x, double z) const {
    Spot spot;
    find(x, z, spot);
    return {place(spot), normal(spot)};
  }

  /// A point of the ground without its normal, which takes most of the time to compute.
  struct Spot {
    /// The position in the coordinates of the mesh.
    vec3 position;
    /// The indices of the cell.
    std::uint32_t i, j;
    /// The weights of the cell's vertices (i, j), (i + 1, j), (i, j + 1) and (i + 1, j + 1).
    float weight[4];
  };
  void find(double x, double z, Spot& spot) const;
  vec3 normal(const Spot& spot) const;
  vec3 place(const Spot& spot) const { return vec3(origin_ + dvec3(spot.position)); }

  bool covers(double x, double z) const;
  const dvec3& origin() const { return origin_; }
  float height(double x, double z) const {
    Spot spot;
    find(x, z, spot);
    return place(spot).y;
  }

 private:
  const mesh::GridMesh& ground_;
  dvec3 origin_;
  /// The lines of the grid along x and along z.
  Lines x_, z_;
};

}  // namespace aerostat::scatter
