#include <algorithm>

#include "scene/io.hpp"
#include "scene/materials.hpp"
#include "scene/palettes.hpp"
#include "scene/scene.hpp"
#include "scene/sun_angles.hpp"

namespace aerostat::scene {

namespace {

/// Makes high mountains in winter: rock and snow over dark conifers, under a low, clear morning
/// sun.
void make_snow(Scene& scene) {
  Terrain& terrain = scene.terrain;
  terrain.warp_m = 2000.0;
  terrain.warp_feature_m = 9000.0;
  terrain.sharpness = 1.15;
  terrain.grading = 20.0;
  Ground& ground = scene.biome.ground;
  ground.cover_a = {0.045f, 0.065f, 0.04f};
  ground.cover_b = {0.12f, 0.115f, 0.07f};
  ground.rock_a = {0.06f, 0.058f, 0.058f};
  ground.rock_b = {0.16f, 0.152f, 0.147f};
  ground.snow = {0.8f, 0.82f, 0.85f};
  ground.rock_slope_deg[0] = 37.0;
  ground.rock_slope_deg[1] = 50.0;
  ground.snow_slope_deg[0] = 45.0;
  ground.snow_slope_deg[1] = 61.0;
  ground.snow_line_m = -1000.0;
  ground.snow_fuzz_m = 300.0;
  ground.forest = {0.045f, 0.06f, 0.032f};
  ground.forest_top_m = 900.0;
  ground.forest_share = 0.47;
  ground.canopy_m = 6.0;
  ground.pattern_m = 140.0;
  ground.strata_m = 90.0;
  ground.softness = 0.35;
  ground.sparkle = 1.0;
  scene.balloon.position = {0.0, 420.0, 0.0};
  scene.balloon.pattern = Pattern::stripes;
  dress(scene.balloon, Palette::ember);
  scene.sun.direction = detail::direction_of({230.0, 15.0});
  scene.air.ground_albedo = {0.5f, 0.52f, 0.55f};
  scene.haze = {90000.0, 1300.0, 1.3, 0.72, vec3(0.96f)};
  scene.sky.cumulus = {0.05, 2900.0, 380.0, 600.0, 1};
}

/// Makes a green island in a warm sea: steep ridges under forest, pale beaches and moist air.
void make_tropical(Scene& scene) {
  Terrain& terrain = scene.terrain;
  terrain.kind = TerrainKind::island;
  terrain.size_m = 24000.0;
  terrain.height_m = 850.0;
  terrain.feature_m = 4000.0;
  terrain.warp_m = 700.0;
  terrain.warp_feature_m = 3500.0;
  terrain.grading = 20.0;
  Ground& ground = scene.biome.ground;
  ground.cover_a = {0.04f, 0.105f, 0.022f};
  ground.cover_b = {0.105f, 0.17f, 0.04f};
  ground.rock_a = {0.13f, 0.115f, 0.095f};
  ground.rock_b = {0.23f, 0.205f, 0.17f};
  ground.rock_slope_deg[0] = 44.0;
  ground.rock_slope_deg[1] = 58.0;
  ground.beach = {0.56f, 0.49f, 0.36f};
  ground.beach_top_m = 3.0;
  ground.pattern_m = 60.0;
  ground.strata_m = 40.0;
  ground.relief = 0.8;
  ground.forest = {0.043f, 0.09f, 0.02f};
  ground.forest_top_m = 1500.0;
  ground.forest_share = 0.85;
  ground.canopy_m = 9.0;
  scene.biome.water.enabled = true;
  scene.biome.water.wave_slope = 0.11;
  scene.balloon.position = {0.0, 210.0, 300.0};
  scene.balloon.pattern = Pattern::chevrons;
  dress(scene.balloon, Palette::lagoon);
  scene.sun.direction = detail::direction_of({150.0, 23.0});
  scene.air.ground_albedo = {0.06f, 0.08f, 0.08f};
  scene.haze = {60000.0, 1000.0, 0.6, 0.76, vec3(0.99f)};
  scene.sky.cumulus = {0.18, 1250.0, 480.0, 480.0, 8};
}

/// Makes a sea of dunes before reddish rock, with dust in the air and a low golden sun.
void make_sand(Scene& scene) {
  Terrain& terrain = scene.terrain;
  terrain.kind = TerrainKind::dunes;
  terrain.size_m = 24000.0;
  terrain.height_m = 320.0;
  terrain.feature_m = 4500.0;
  terrain.warp_m = 300.0;
  terrain.warp_feature_m = 1800.0;
  terrain.grading = 20.0;
  terrain.dunes = {250.0, 460.0, 75.0};
  Ground& ground = scene.biome.ground;
  ground.cover_a = {0.47f, 0.29f, 0.15f};
  ground.cover_b = {0.56f, 0.38f, 0.21f};
  ground.rock_a = {0.27f, 0.13f, 0.075f};
  ground.rock_b = {0.38f, 0.21f, 0.125f};
  ground.rock_slope_deg[0] = 37.0;
  ground.rock_slope_deg[1] = 48.0;
  ground.pattern_m = 160.0;
  ground.strata_m = 55.0;
  ground.softness = 0.45;
  ground.sparkle = 0.15;
  ground.relief = 0.07;
  ground.ripple_m = 0.9;
  scene.balloon.position = {0.0, 150.0, 0.0};
  scene.balloon.pattern = Pattern::rainbow;
  dress(scene.balloon, Palette::spectrum);
  scene.sun.direction = detail::direction_of({80.0, 12.0});
  scene.air.ground_albedo = {0.42f, 0.28f, 0.16f};
  scene.haze = {50000.0, 1200.0, 0.3, 0.75, {0.97f, 0.94f, 0.88f}};
  scene.sky.cumulus = {0.0, 2400.0, 300.0, 500.0, 1};
}

/// Puts the camera across the gap from the balloon, which fills a third of the picture's height.
/// The camera stands at `stand` and aims at `look`. Both are in metres from the floor of the
/// basket.
void make_outside(Scene& scene, const dvec3& stand, const dvec3& look) {
  const dvec3 below(scene.balloon.position.x, 0.0, scene.balloon.position.z);
  scene.camera.height_above = HeightReference::balloon;
  scene.camera.position = below + stand;
  scene.camera.target = below + look;
  scene.camera.fov_y_deg = 45.0;
}

void make_basket(Scene& scene) {
  scene.camera.height_above = HeightReference::balloon;
  scene.camera.position.reset();
  scene.camera.target.reset();
  scene.camera.fov_y_deg = 62.0;
}

}  // namespace

Scene defaults(BiomeKind biome, View view) {
  Scene scene;
  scene.biome.kind = biome;
  scene.camera.view = view;
  scene.balloon.height_above = HeightReference::ground;
  scene.materials = detail::default_materials(biome);
  switch (biome) {
    case BiomeKind::snow:
      make_snow(scene);
      make_outside(scene, {-10.0, -4.0, 86.0}, {16.0, 12.0, 0.0});
      break;
    case BiomeKind::tropical:
      make_tropical(scene);
      make_outside(scene, {-80.0, 10.0, 40.0}, {0.0, 5.0, 11.0});
      break;
    case BiomeKind::sand:
      make_sand(scene);
      make_outside(scene, {0.0, 8.0, 86.0}, {13.0, 1.0, 0.0});
      break;
  }
  if (view == View::basket) make_basket(scene);
  set_quality(scene, Quality::standard);
  return scene;
}

void set_quality(Scene& scene, Quality quality) {
  constexpr int kSamples[] = {1, 4, 256};
  scene.quality = quality;
  scene.image.adaptive_threshold = quality == Quality::final ? 0.008 : 0.0;
  scene.image.spp = kSamples[static_cast<std::size_t>(quality)];
  scene.sun.soft_shadows = quality != Quality::draft;
  scene.sky.ambient_occlusion = quality != Quality::draft;
}

void set_haze_droplets(Haze& haze, double visibility_m) {
  constexpr double kDryFrom = 6000.0;
  if (visibility_m >= kDryFrom) return;
  const double km = visibility_m / 1000.0;
  const double most = km > 1.0 ? 0.16 * km + 0.34 : std::max(0.0, km - 0.5);
  haze.angstrom = std::min(haze.angstrom, most);
  haze.albedo =
      vec3(1.0f) - (vec3(1.0f) - haze.albedo) * static_cast<float>(visibility_m / kDryFrom);
}

}  // namespace aerostat::scene
