#include "height_field.hpp"

#include <mutex>

#include "relief.hpp"

namespace aerostat::terrain {
namespace {

std::unique_ptr<Relief> make_relief(const scene::Terrain& terrain) {
  switch (terrain.kind) {
    case scene::TerrainKind::island:
      return make_island(terrain);
    case scene::TerrainKind::dunes:
      return make_dunes(terrain);
    case scene::TerrainKind::mountains:
      break;
  }
  return make_mountains(terrain);
}

/// The relief of the last terrain asked for: placing a scene's objects and building its meshes ask
/// for the same one in turn, and carving it takes longer than anything else about it.
std::shared_ptr<const Relief> relief_of(const scene::Terrain& terrain) {
  static std::mutex mutex;
  static std::shared_ptr<const Relief> relief;
  static scene::Terrain made_for;
  const std::lock_guard lock(mutex);
  if (!relief || made_for != terrain) {
    relief = nullptr;
    relief = make_relief(terrain);
    made_for = terrain;
  }
  return relief;
}

}  // namespace

HeightField::HeightField(const scene::Terrain& terrain)
    : relief_(relief_of(terrain)),
      center_(terrain.center),
      base_m_(static_cast<float>(terrain.base_m)) {}

void HeightField::heights(const Points& points, Block& height) const {
  relief_->heights(points, height);
  for (int i = 0; i < points.count; ++i) height[i] += base_m_;
}

double HeightField::height(double x, double z) const {
  Points points;
  points.count = 1;
  points.x[0] = static_cast<float>(x - center_.x);
  points.z[0] = static_cast<float>(z - center_.y);
  points.spacing[0] = 0.0f;
  Block height;
  heights(points, height);
  return height[0];
}

vec3 HeightField::normal(double x, double z, double spacing) const {
  Points points;
  points.count = 4;
  const double offsets[4][2] = {{-spacing, 0.0}, {spacing, 0.0}, {0.0, -spacing}, {0.0, spacing}};
  for (int i = 0; i < 4; ++i) {
    points.x[i] = static_cast<float>(x + offsets[i][0] - center_.x);
    points.z[i] = static_cast<float>(z + offsets[i][1] - center_.y);
    points.spacing[i] = static_cast<float>(spacing);
  }
  Block height;
  heights(points, height);
  return glm::normalize(
      vec3(height[0] - height[1], static_cast<float>(2.0 * spacing), height[2] - height[3]));
}

}  // namespace aerostat::terrain
