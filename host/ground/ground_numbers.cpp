#include "ground/ground_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/copy.hpp"
#include "scene/scene.hpp"

namespace aerostat::ground {
namespace {

float cosine_of_deg(double degrees) {
  return static_cast<float>(std::cos(degrees * (std::numbers::pi / 180.0)));
}

/// Returns a wavelength in metres, or 0, which stands for no waves.
float wavelength_or_none(double metres) {
  return metres < kShortestWaveM ? 0.0f : static_cast<float>(metres);
}

}  // namespace

AeroGround ground_numbers(const scene::Scene& scene) {
  const scene::Ground& from = scene.biome.ground;
  AeroGround ground{};
#define AERO_NUMBER(member, source) ground.member = static_cast<float>(from.source);
  AERO_GROUND_NUMBERS(AERO_NUMBER)
#undef AERO_NUMBER
  copy(ground.cover_a, from.cover_a);
  copy(ground.cover_b, from.cover_b);
  copy(ground.rock_a, from.rock_a);
  copy(ground.rock_b, from.rock_b);
  copy(ground.snow, from.snow);
  copy(ground.beach, from.beach);
  for (int i = 0; i < 2; ++i) {
    ground.rock_cos[i] = cosine_of_deg(from.rock_slope_deg[i]);
    ground.snow_cos[i] = cosine_of_deg(from.snow_slope_deg[i]);
  }
  ground.pattern = static_cast<float>(std::max(from.pattern_m, kShortestWaveM));
  ground.ripple = wavelength_or_none(from.ripple_m);
  ground.strata = wavelength_or_none(from.strata_m);
  copy(ground.forest, from.forest);
  copy(ground.field, from.field);
  const vec3 wind = direction_from_angles(
      radians_from_degrees(static_cast<float>(scene.terrain.dunes.wind_deg)), 0.0f);
  ground.wind[0] = wind.x;
  ground.wind[1] = wind.z;
  ground.seed = scene.terrain.seed;
  ground.has_cover = scene.terrain.cover.source.empty() ? 0u : 1u;
  ground.fall = static_cast<float>(scene::ground_fall(scene.terrain));
  return ground;
}

}  // namespace aerostat::ground
