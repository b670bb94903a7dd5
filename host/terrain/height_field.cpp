#include "height_field.hpp"

#include "relief.hpp"
#include "terrain/cover.hpp"

namespace aerostat::terrain {
namespace {

std::unique_ptr<Relief> make_relief(const scene::Terrain& terrain, Carving carving,
                                    ReliefCache& cache) {
  switch (terrain.kind) {
    case scene::TerrainKind::elevation:
      return make_real_land(terrain, real_land(terrain, cache.lands),
                            cover_of(terrain, cache).get());
    case scene::TerrainKind::island:
      return make_island(terrain, carving);
    case scene::TerrainKind::dunes:
      return make_dunes(terrain);
    case scene::TerrainKind::mountains:
      break;
  }
  return make_mountains(terrain, carving);
}

/// A terrain as far as its relief goes by it: neither by where it lies nor by the mesh.
scene::Terrain shape_of(scene::Terrain terrain) {
  const scene::Terrain any;
  terrain.cells = any.cells;
  terrain.center = any.center;
  terrain.grading = any.grading;
  terrain.base_m = any.base_m;
  terrain.drape = any.drape;
  return terrain;
}

std::shared_ptr<const Relief> relief_of(const scene::Terrain& terrain, Carving carving,
                                        ReliefCache& cache) {
  const scene::Terrain shape = shape_of(terrain);
  return cache.of(carving).get(
      shape, [&] { return std::shared_ptr<const Relief>(make_relief(shape, carving, cache)); });
}

}  // namespace

HeightField::HeightField(const scene::Terrain& terrain, Carving carving, ReliefCache& cache)
    : relief_(relief_of(terrain, carving, cache)),
      center_(terrain.center),
      base_m_(static_cast<float>(terrain.base_m)) {}

HeightField::HeightField(const scene::Terrain& terrain, Carving carving)
    : relief_(relief_of(terrain, carving, *std::make_unique<ReliefCache>())),
      center_(terrain.center),
      base_m_(static_cast<float>(terrain.base_m)) {}

void HeightField::heights(const Points& points, Block& height) const {
  relief_->heights(points, height);
  for (int i = 0; i < points.count; ++i) height[i] += base_m_;
}

bool HeightField::has_water() const {
  return relief_->has_water();
}

void HeightField::water_levels(const Points& points, Block& level) const {
  relief_->water_levels(points, level);
  for (int i = 0; i < points.count; ++i) level[i] += base_m_;
}

Points HeightField::point_at(double x, double z, double spacing) const {
  Points points;
  points.count = 1;
  points.x[0] = static_cast<float>(x - center_.x);
  points.z[0] = static_cast<float>(z - center_.y);
  points.spacing[0] = static_cast<float>(spacing);
  return points;
}

double HeightField::height(double x, double z, double spacing) const {
  Block height;
  heights(point_at(x, z, spacing), height);
  return height[0];
}

std::optional<double> HeightField::water_level(double x, double z, double spacing) const {
  if (!has_water()) return std::nullopt;
  const Points point = point_at(x, z, spacing);
  Block ground, level;
  heights(point, ground);
  water_levels(point, level);
  // A level that is not near is no number.
  if (!(level[0] > ground[0])) return std::nullopt;
  return level[0];
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
