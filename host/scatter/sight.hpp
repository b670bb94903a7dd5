#pragma once

#include <optional>

#include "scatter/height_tiles.hpp"
#include "scene/scene.hpp"

namespace aerostat::scatter {

/// How far a plant goes from the place that it is looked up at, in plan, and above the ground.
struct Extent {
  double aside_m = 0.0;
  double above_m = 0.0;
};

/// Where on the map things stand that a picture can show, or that can keep light from what it
/// shows. What stands elsewhere no ray of the renderer meets, so that the picture is the same
/// without it.
class Sight {
 public:
  /// For a resolved scene upon `ground`, which count from the same origin, as far as `reach_m` from
  /// the eye.
  Sight(const scene::Scene& scene, const mesh::GridMesh& ground, double reach_m,
        const Extent& extent);

  /// What stands at some z.
  class Row {
   public:
    bool matters(double x) const {
      const int column = map_->column(x);
      return !map_->holds(column, row_) || of_row_[column] != 0;
    }

   private:
    friend class Sight;
    const TileMap* map_;
    int row_;
    const char* of_row_;  // if the map holds it
  };

  Row row(double z) const {
    Row result;
    result.map_ = &map_;
    result.row_ = map_.row(z);
    result.of_row_ = map_.holds(0, result.row_) ? &matters_[map_.at(0, result.row_)] : nullptr;
    return result;
  }

  /// Whether something that stands at (x, z), within the extent, can matter. A quick look-up.
  bool matters(double x, double z) const { return row(z).matters(x); }

 private:
  TileMap map_;
  std::vector<char> matters_;  // by tile
};

/// Whether two scenes with the same land and plants have the same sight.
bool same_sight(const scene::Scene& a, const scene::Scene& b);

/// The directions of a picture in plan: those between two, which are less than half a turn apart.
struct PlanView {
  dvec2 left{0.0}, right{0.0};  // unit, x and z

  /// Whether a square of half a side `half` around `middle`, both relative to the eye, can be in
  /// it.
  bool touches(const dvec2& middle, double half) const;
};

/// Of a pinhole; none if it looks straight up or down, or for other lenses.
std::optional<PlanView> plan_view(const scene::Camera& camera, const scene::Image& image);

}  // namespace aerostat::scatter
