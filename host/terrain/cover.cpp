#include "terrain/cover.hpp"

#include "terrain/real_land.hpp"

namespace aerostat::terrain {
namespace {

/// Half of the side of the square that land cover is looked at, as a share of the terrain's side.
/// It reaches a little farther than the ground.
constexpr double kReach = 0.55;

}  // namespace

std::shared_ptr<const land::Cover> cover_of(const scene::Terrain& terrain, ReliefCache& cache) {
  const scene::LandCover& from = terrain.cover;
  if (from.source.empty()) return nullptr;
  const std::shared_ptr<const land::Land> land = real_land(terrain, cache.lands);
  land::CoverOptions options;
  options.file = from.source;
  options.crs = from.crs;
  options.scheme = from.scheme;
  for (const scene::CoverCode& one : from.classes) options.classes[one.code] = one.is;
  options.middle = middle_point(terrain, *land);
  options.reach_m = kReach * terrain.size_m;
  return cache.covers.get(options, [&] { return std::make_shared<const land::Cover>(options); });
}

}  // namespace aerostat::terrain
