#include "terrain/drape.hpp"

#include <array>

#include "terrain/real_land.hpp"

namespace aerostat::terrain {
namespace {

/// Half of the side of the square that a picture is looked at, as a share of the terrain's side. It
/// reaches as far as the ground does.
constexpr double kReach = 0.5;

geo::Place place_from(const dvec2& degrees) {
  return {degrees.x, degrees.y};
}

}  // namespace

std::shared_ptr<const land::Drape> drape_of(const scene::Terrain& terrain, ReliefCache& cache) {
  const scene::Drape& from = terrain.drape;
  if (from.file.empty() || from.blend <= 0.0) return nullptr;
  const std::shared_ptr<const land::Land> land = real_land(terrain, cache.lands);
  land::DrapeOptions options;
  options.file = from.file;
  options.picture.crs = from.crs;
  if (from.corners.north_west) {
    options.picture.corners =
        std::array{place_from(*from.corners.north_west), place_from(*from.corners.south_east)};
  }
  options.middle = middle_point(terrain, *land);
  options.reach_m = kReach * terrain.size_m;
  options.lift_shadows = from.lift_shadows;
  if (from.lift_shadows > 0.0) options.land = land;
  return cache.drapes.get(options, [&] { return std::make_shared<const land::Drape>(options); });
}

}  // namespace aerostat::terrain
