#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scatter/height_tiles.hpp"
#include "scatter/obstacle.hpp"
#include "scene/picture.hpp"
#include "scene/resolved_scene.hpp"

namespace aerostat::scatter {

/// The largest distances that a plant reaches from the point at which its tile is looked up: in
/// plan, and above the ground. Both are in metres.
struct Extent {
  double aside_m = 0.0;
  double above_m = 0.0;
};

/// Determines where on the map objects stand that a picture can show, or that can keep light from
/// what it shows. No ray of the renderer hits the other objects, so the picture is the same without
/// them.
class Sight {
 public:
  /// Computes the sight of a scene as far as `reach_m` from the eye. `ground` counts from the
  /// scene's origin.
  Sight(const scene::ResolvedScene& scene, const mesh::GridMesh& ground, double reach_m,
        const Extent& extent, std::span<const Obstacle> obstacles = {});

  /// The sight along a row of tiles.
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
    /// The flags of the row, or null if the map does not contain it.
    const char* of_row_;
  };

  Row row(double z) const {
    Row result;
    result.map_ = &map_;
    result.row_ = map_.row(z);
    result.of_row_ = map_.holds(0, result.row_) ? &matters_[map_.at(0, result.row_)] : nullptr;
    return result;
  }

  /// Returns whether an object that stands at (x, z) and keeps within the extent can matter. It is
  /// a quick look-up.
  bool matters(double x, double z) const { return row(z).matters(x); }

 private:
  TileMap map_;
  /// A flag for each tile.
  std::vector<char> matters_;
};

/// Returns whether two scenes with the same land, plants and obstacles have the same sight.
bool same_sight(const scene::ResolvedScene& now, const scene::ResolvedScene& before);

/// The directions of a picture in plan. They lie between two directions that are less than half a
/// turn apart.
struct PlanView {
  /// The two border directions as unit vectors of x and z.
  dvec2 left{0.0}, right{0.0};

  /// Returns whether a square can be in the view. Its half side is `half`, and its middle is
  /// relative to the eye.
  bool touches(const dvec2& middle, double half) const;
};

/// Returns the plan view of a pinhole camera. Returns nothing if it looks straight up or down, or
/// has another lens.
std::optional<PlanView> plan_view(const scene::Camera& camera, const scene::Image& image);

}  // namespace aerostat::scatter
