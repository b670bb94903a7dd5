#pragma once

#include <vector>

#include "mesh/grid_mesh.hpp"

namespace aerostat::scatter {

/// A point of the ground as it is rendered.
struct SurfacePoint {
  vec3 position{0.0f};
  vec3 normal{0.0f, 1.0f, 0.0f};  // unit, interpolated as in shading
};

/// Ascending lines, among which the cell that holds a value is found in a step or two.
class Lines {
 public:
  void add(float line) { lines_.push_back(line); }
  /// To be called when all are there, two at least.
  void index();

  /// The cell, and where in it, 0 to 1; beyond all lines the first or last cell.
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
  std::vector<std::uint32_t> first_;  // cells that hold the lower ends of as many even parts
  double parts_per_m_ = 0.0;
};

/// The ground's mesh as a function of the place; `ground` must outlive this.
class Surface {
 public:
  /// The ground counts from a point whose place over the terrain is `origin`. All that follows is
  /// asked by places, metres.
  explicit Surface(const mesh::GridMesh& ground, const dvec3& origin = dvec3(0.0));

  /// The point of the triangle over or under (x, z); outside the mesh its rim goes on level.
  SurfacePoint at(double x, double z) const {
    Spot spot;
    find(x, z, spot);
    return {place(spot), normal(spot)};
  }

  /// The same without its normal, which takes most of the time.
  struct Spot {
    vec3 position;       // as the mesh counts
    std::uint32_t i, j;  // the cell
    float weight[4];     // of its vertices (i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)
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
  Lines x_, z_;  // the grid's
};

}  // namespace aerostat::scatter
