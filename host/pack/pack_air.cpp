#include "pack/pack_air.hpp"

#include <algorithm>

#include "air/light.hpp"
#include "core/copy.hpp"
#include "pack/pack_night.hpp"
#include "rules/daylight.h"
#include "scene/key_light.hpp"
#include "scene/scene.hpp"

namespace aerostat::pack {
namespace {

static_assert(static_cast<float>(air::kFogAsymmetry) == FOG_ASYMMETRY);
static_assert(static_cast<float>(air::kFogDirect) == FOG_DIRECT);

AeroFog pack_fog(const scene::Fog& from, const air::FogLayer& layer, double sun_cosine) {
  AeroFog fog{};
  fog.extinction = static_cast<float>(layer.extinction);
  fog.top = static_cast<float>(layer.top);
  fog.softness = static_cast<float>(layer.softness);
  fog.billow = static_cast<float>(from.billow_m);
  fog.billow_width = static_cast<float>(from.billow_width_m);
  fog.sun_way = static_cast<float>(1.0 / std::max(sun_cosine, air::kLowestFogSun));
  return fog;
}

}  // namespace

std::vector<AeroSkyCell> pack_sky_table(const air::SkyTable& table) {
  static_assert(AERO_SKY_COLUMNS == air::SkyTable::kColumns);
  static_assert(AERO_SKY_ROWS_ABOVE == air::SkyTable::kRowsAbove);
  static_assert(AERO_SKY_ROWS_BELOW == air::SkyTable::kRowsBelow);
  static_assert(AERO_SKY_CELLS == AERO_SKY_COLUMNS * (AERO_SKY_ROWS_ABOVE + AERO_SKY_ROWS_BELOW));
  std::vector<AeroSkyCell> cells(AERO_SKY_CELLS);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    copy(cells[i].add, table.cells()[i].add);
    copy(cells[i].haze, table.cells()[i].haze);
  }
  return cells;
}

namespace {

/// Returns a sky of one radiance and no air. Its light is no multiple of the sun's (see
/// AeroSky::is_even).
PackedAir even_sky(const vec3& radiance) {
  PackedAir packed;
  AeroAir& air = packed.numbers;
  // The heights divide others, so they must not be 0.
  air.molecules_height = air.haze_height = 1e4f;
  air.sun_heights[0] = -2e9f;
  air.sun_heights[1] = -1e9f;
  air.around_top = 1.0f;
  copy(air.ambient[0], radiance);
  AeroSkyCell cell{};
  copy(cell.add, radiance);
  packed.sky_table.assign(AERO_SKY_CELLS, cell);
  return packed;
}

}  // namespace

PackedAir pack_air(const scene::ResolvedScene& scene, air::ScatteringCache& cache) {
  if (scene->sky.radiance) return even_sky(*scene->sky.radiance);
  const air::Light light(scene, cache);
  const air::Atmosphere& from = light.atmosphere;
  PackedAir packed;
  AeroAir& air = packed.numbers;
  copy(air.molecules, from.molecules);
  copy(air.haze_scattering, from.haze_scattering);
  copy(air.haze_extinction, from.haze_extinction);
  air.molecules_height = static_cast<float>(from.molecules_height);
  air.haze_height = static_cast<float>(from.haze_height);
  air.haze_asymmetry = static_cast<float>(from.haze_asymmetry);
  copy(air.depth_molecules, light.depth_molecules);
  copy(air.depth_haze, light.depth_haze);
  copy(air.depth_ozone, light.depth_ozone);
  for (std::size_t i = 0; i < 2; ++i) {
    air.sun_heights[i] = static_cast<float>(light.sun_heights[i]);
  }
  copy(air.scattered_depth_haze, light.scattered_depth_haze);
  for (std::size_t i = 0; i < 3; ++i) {
    copy(air.around[i], light.around[i]);
    copy(air.around_slant[i], light.around_slant[i]);
  }
  copy(air.around_least, light.around_least);
  air.around_top = static_cast<float>(light.around_top);
  air.thick_haze = light.thick_haze ? 1.0f : 0.0f;
  for (std::size_t i = 0; i < 9; ++i) copy(air.ambient[i], light.ambient[i]);
  copy(air.above_clouds, light.above_clouds);
  copy(air.below_clouds, light.below_clouds);
  air.deck_base = static_cast<float>(light.deck_base);
  air.deck_sun = static_cast<float>(light.deck_sun);
  air.deck_level = static_cast<float>(light.deck_level);
  air.deck_around = static_cast<float>(light.deck_around);
  air.fog = pack_fog(scene->fog, from.fog, scene::key_light(*scene).direction.y);
  air.horizon_sine = static_cast<float>(light.sky.horizon_sine());
  packed.sky_table = pack_sky_table(light.sky);
  packed.night = pack_night(scene, light, packed.sky_table);
  return packed;
}

}  // namespace aerostat::pack
