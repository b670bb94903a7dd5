#include "scatter/sight.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "scene/at_rest.hpp"
#include "scene/key_light.hpp"
#include "scene/local_frame.hpp"
#include "scene/scene.hpp"
#include "scene/view_axes.hpp"

namespace aerostat::scatter {
namespace {

constexpr double kLeastTile_m = 32.0;
// The spread of directions of the sun's disc and of their rounding, in radians.
constexpr double kSunSpread_rad = 0.006;
// The width in pixels of the margin around the picture into which filters reach, rounded up
// generously.
constexpr double kAround = 4.0;
// The distances in tiles within which the ground must be higher, so that it hides a tile on all
// rays to it. The objects in a tile widen the tile. This many tiles around the ray to its middle
// cover the whole bundle of rays.
constexpr int kWidth = 2, kSunWidth = 3;
// The longest ambient occlusion in metres for which the sight is limited. Beyond it, everything
// matters.
constexpr double kMostOcclusion_m = 2000.0;

double cross(const dvec2& a, const dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// Determines for each tile whether it matters. The positions of the scene count from `origin`.
class Survey {
 public:
  Survey(const scene::Scene& scene, const dvec3& origin, const mesh::GridMesh& ground,
         const TileMap& map, const Extent& extent, std::span<const Obstacle> obstacles)
      : scene_(scene),
        origin_(origin),
        map_(map),
        extent_(extent),
        obstacles_(obstacles),
        view_(plan_view(scene.camera, scene.image)),
        tiles_(height_tiles(map, ground)),
        barrier_(least_around(map, tiles_.lowest, kWidth)),
        sun_barrier_(least_around(map, tiles_.lowest, kSunWidth)) {}

  std::vector<char> run() const {
    const std::vector<char> seen = tiles_seen();
    std::vector<char> matters = seen;
    if (scene_.sky.ambient_occlusion) {
      matters = any_around(map_, seen, tiles_across(scene_.sky.occlusion_m));
    }
    if (!scene_.sun.shadows) return matters;
    const std::vector<char> lit = any_around(map_, seen, kSunWidth);
    const Shadows shadows = this->shadows();
    each_tile([&](int column, int row) {
      char& one = matters[map_.at(column, row)];
      if (one == 0) one = may_shade(column, row, shadows, lit) ? 1 : 0;
    });
    return matters;
  }

 private:
  int tiles_across(double metres) const {
    return static_cast<int>(std::ceil((metres + extent_.aside_m) / map_.tile_m)) + 1;
  }

  template <class F>
  void each_tile(const F& f) const {
    tbb::parallel_for(0, map_.side, [&](int row) {
      for (int column = 0; column < map_.side; ++column) f(column, row);
    });
  }

  std::vector<char> tiles_seen() const {
    std::vector<char> seen(map_.count(), 0);
    each_tile(
        [&](int column, int row) { seen[map_.at(column, row)] = is_seen(column, row) ? 1 : 0; });
    return seen;
  }

  bool is_seen(int column, int row) const {
    const dvec2 middle = map_.middle(column, row);
    if (holds_obstacle(middle)) return true;
    const dvec3& eye = *scene_.camera.position;
    const double half = 0.5 * map_.tile_m + extent_.aside_m;
    if (view_ && !view_->touches(middle - dvec2(eye.x, eye.z), half)) return false;
    return !is_hidden(column, row, top_of(column, row));
  }

  bool holds_obstacle(const dvec2& middle) const {
    return std::any_of(obstacles_.begin(), obstacles_.end(), [&](const Obstacle& obstacle) {
      const dvec2 away = glm::abs(middle - (square_of(obstacle) - dvec2(origin_.x, origin_.z)));
      return std::max(away.x, away.y) <
             0.5 * kObstacleSquare_m + obstacle.width_m + extent_.aside_m + map_.tile_m;
    });
  }

  /// Returns a height that nothing in the tile exceeds: neither ground nor water nor plants.
  double top_of(int column, int row) const {
    const scene::Water& water = scene_.biome.water;
    const auto ground = static_cast<double>(tiles_.highest[map_.at(column, row)]);
    return (water.enabled ? std::max(ground, water.level_m) : ground) + extent_.above_m + 1.0;
  }

  /// Returns whether ground hides a whole tile. The eye is in the middle of the map, so all rays to
  /// tiles lie on the map.
  bool is_hidden(int column, int row, double top) const {
    const double eye = scene_.camera.position->y;
    // The place of the eye in tiles. The places below are in tiles as well.
    const double from = 0.5 * map_.side;
    const dvec2 way = dvec2(column + 0.5, row + 0.5) - from;
    const int steps = static_cast<int>(std::hypot(way.x, way.y));
    const dvec2 step = way / static_cast<double>(steps);
    const double rise = (top - eye) / static_cast<double>(steps);
    for (int k = 1; k < steps; ++k) {
      const auto i = static_cast<int>(from + k * step.x), j = static_cast<int>(from + k * step.y);
      if (static_cast<double>(barrier_[map_.at(i, j)]) > eye + k * rise) return true;
    }
    return false;
  }

  /// The movement of shadows from tile to tile. `step` is in tiles, and `drop` is the loss of
  /// height in metres.
  struct Shadows {
    dvec2 step{0.0};
    double drop = 0.0;
    /// The most steps of a shadow. Beyond them, the sun's disc has made the bundle a tile wider.
    int most = 0;
  };

  Shadows shadows() const {
    const dvec3 sun = scene::key_light(scene_).direction;
    const double level = std::hypot(sun.x, sun.z);
    Shadows shadows;
    if (level > 0.0) shadows.step = dvec2(sun.x, sun.z) * (-1.0 / level);
    shadows.drop = std::tan(std::asin(sun.y) - kSunSpread_rad) * map_.tile_m;
    shadows.most = static_cast<int>(0.5 / kSunSpread_rad * std::max(level, 0.02));
    return shadows;
  }

  /// Returns whether the shadow of objects in the tile may fall on something visible before it
  /// falls on the ground.
  bool may_shade(int column, int row, const Shadows& shadows, const std::vector<char>& seen) const {
    dvec2 at(column + 0.5, row + 0.5);
    double height = top_of(column, row);
    const bool stays = shadows.step == dvec2(0.0);
    for (int k = 0; k < shadows.most; ++k, at += shadows.step, height -= shadows.drop) {
      if (at.x < 0.0 || at.y < 0.0) return true;
      const int i = static_cast<int>(at.x), j = static_cast<int>(at.y);
      if (!map_.holds(i, j) || seen[map_.at(i, j)] != 0) return true;
      if (height < static_cast<double>(sun_barrier_[map_.at(i, j)])) return false;
      if (stays) return false;
    }
    return true;
  }

  const scene::Scene& scene_;
  dvec3 origin_;
  const TileMap& map_;
  Extent extent_;
  std::span<const Obstacle> obstacles_;
  std::optional<PlanView> view_;
  HeightTiles tiles_;
  std::vector<float> barrier_, sun_barrier_;
};

/// Returns whether light may come from anywhere, or rays may start elsewhere than at the eye.
bool knows_no_bounds(const scene::Scene& scene) {
  const scene::Lens lens = scene.camera.lens;
  if (lens != scene::Lens::pinhole && lens != scene::Lens::panorama) return true;
  const bool lamps = std::any_of(scene.lights.begin(), scene.lights.end(),
                                 [](const scene::PointLight& light) { return light.shadows; });
  return lamps || (scene.sky.ambient_occlusion && scene.sky.occlusion_m > kMostOcclusion_m);
}

}  // namespace

bool PlanView::touches(const dvec2& middle, double half) const {
  // The square is beyond a border if its corner that is farthest inside is beyond it.
  const auto beyond = [&](const dvec2& border, double side) {
    return side * cross(border, middle) + half * (std::abs(border.x) + std::abs(border.y)) < 0.0;
  };
  return !beyond(left, 1.0) && !beyond(right, -1.0);
}

std::optional<PlanView> plan_view(const scene::Camera& camera, const scene::Image& image) {
  if (camera.lens != scene::Lens::pinhole) return std::nullopt;
  const auto [aside, up, ahead] = scene::view_axes(camera);
  const double tall =
      std::tan(0.5 * glm::radians(camera.fov_y_deg)) * (1.0 + kAround / image.height);
  const double wide = tall * (image.width + kAround) / image.height;
  // The view of an eye that looks straight up or down has no sides.
  if (std::abs(aside.y) <= wide * std::abs(ahead.y) && std::abs(up.y) <= tall * std::abs(ahead.y)) {
    return std::nullopt;
  }
  dvec2 corners[4];
  for (int k = 0; k < 4; ++k) {
    const dvec3 d = ahead + aside * (k % 2 == 0 ? -wide : wide) + up * (k / 2 == 0 ? -tall : tall);
    corners[k] = {d.x, d.z};
  }
  PlanView view{corners[0], corners[0]};
  for (const dvec2& corner : corners) {
    if (cross(view.left, corner) < 0.0) view.left = corner;
    if (cross(view.right, corner) > 0.0) view.right = corner;
  }
  view.left = glm::normalize(view.left);
  view.right = glm::normalize(view.right);
  return view;
}

Sight::Sight(const scene::ResolvedScene& scene, const mesh::GridMesh& ground, double reach_m,
             const Extent& extent, std::span<const Obstacle> obstacles) {
  if (knows_no_bounds(*scene)) return;
  const scene::Scene local = scene::counted_from_origin(scene);
  const dvec3& eye = *local.camera.position;
  map_.tile_m = std::max({kLeastTile_m, extent.aside_m, reach_m / 256.0});
  map_.side = 2 * static_cast<int>(std::ceil(reach_m / map_.tile_m)) + 1;
  map_.corner = dvec2(eye.x, eye.z) - 0.5 * map_.tile_m * map_.side;
  matters_ = Survey(local, scene.origin(), ground, map_, extent, obstacles).run();
}

bool same_sight(const scene::ResolvedScene& now, const scene::ResolvedScene& before) {
  const scene::Scene &a = *now, &b = *before;
  const auto same_lights = [&] { return knows_no_bounds(a) == knows_no_bounds(b); };
  return a.camera.position == b.camera.position && a.camera.target == b.camera.target &&
         a.camera.up == b.camera.up && a.camera.lens == b.camera.lens &&
         a.camera.fov_y_deg == b.camera.fov_y_deg && a.image.width == b.image.width &&
         a.image.height == b.image.height &&
         scene::key_light(a).direction == scene::key_light(b).direction &&
         a.sun.shadows == b.sun.shadows && a.sky.ambient_occlusion == b.sky.ambient_occlusion &&
         a.sky.occlusion_m == b.sky.occlusion_m &&
         scene::at_rest(a.biome).water == scene::at_rest(b.biome).water && same_lights();
}

}  // namespace aerostat::scatter
