#include <algorithm>
#include <cmath>

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

/// Makes rolling hills of meadows, fields and woods around a lake, under a mild afternoon sun.
void make_meadow(Scene& scene) {
  Terrain& terrain = scene.terrain;
  terrain.size_m = 24000.0;
  terrain.height_m = 520.0;
  terrain.base_m = -52.0;
  terrain.feature_m = 5200.0;
  terrain.warp_m = 900.0;
  terrain.warp_feature_m = 4200.0;
  terrain.sharpness = 1.1;
  terrain.erosion = 0.25;
  terrain.grading = 20.0;
  terrain.fractal.gain = 0.42;
  Ground& ground = scene.biome.ground;
  ground.rock_a = {0.10f, 0.095f, 0.085f};
  ground.rock_b = {0.20f, 0.19f, 0.17f};
  ground.rock_slope_deg[0] = 42.0;
  ground.rock_slope_deg[1] = 56.0;
  ground.pattern_m = 90.0;
  ground.relief = 0.35;
  ground.forest_top_m = 1400.0;
  ground.forest_share = 0.42;
  ground.canopy_m = 6.5;
  ground.field_m = 110.0;
  scene.biome.water.enabled = true;
  scene.biome.water.wave_m = 4.0;
  scene.biome.water.wave_slope = 0.03;
  scene.biome.water.absorption_per_m = {0.6f, 0.16f, 0.12f};
  scene.biome.water.scatter = {0.012f, 0.04f, 0.04f};
  scene.biome.water.bed = {0.16f, 0.14f, 0.10f};
  scene.balloon.position = {0.0, 140.0, 0.0};
  scene.balloon.pattern = Pattern::spiral;
  dress(scene.balloon, Palette::meadow);
  scene.sun.direction = detail::direction_of({235.0, 24.0});
  scene.air.ground_albedo = {0.10f, 0.12f, 0.05f};
  scene.haze = {45000.0, 1200.0, 1.2, 0.76, vec3(0.96f)};
  scene.sky.cumulus = {0.22, 1300.0, 420.0, 520.0, 3};
  set_season(scene, Season::summer);
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

/// Raises or lowers the sun and leaves its azimuth.
void place_sun(Scene& scene, double elevation_deg) {
  const double azimuth_deg = detail::angles_of(scene.sun.direction).azimuth_deg;
  scene.sun.direction = detail::direction_of({azimuth_deg, elevation_deg});
}

/// Puts the moon beside the sun's azimuth, by degrees to the right.
void place_moon(Scene& scene, double turn_deg, double elevation_deg) {
  const double azimuth_deg = detail::angles_of(scene.sun.direction).azimuth_deg + turn_deg;
  scene.moon.enabled = true;
  scene.moon.azimuth_deg = std::remainder(azimuth_deg, 360.0);
  scene.moon.elevation_deg = elevation_deg;
}

/// Makes the haze of a mood, which is never clearer than the biome's own air.
void make_hazy(Scene& scene, double visibility_m) {
  scene.haze.visibility_m = std::min(scene.haze.visibility_m, visibility_m);
}

/// Fills the valleys with fog.
void make_foggy(Scene& scene, double visibility_m, double top_m) {
  scene.fog.enabled = true;
  scene.fog.visibility_m = visibility_m;
  scene.fog.top_m = top_m;
}

void make_stormy(Scene& scene) {
  place_sun(scene, 16.0);
  make_hazy(scene, 22000.0);
  scene.sky.cloud_cover = 0.9;
  scene.sky.cumulus = {0.8, 1500.0, 1800.0, 1700.0, scene.sky.cumulus.seed};
  scene.image.vignette = 0.15;
}

/// Sets sun, moon, air, clouds and film. All numbers are chosen by eye. A white balance above that
/// of the light keeps the light's own warmth.
void set_mood(Scene& scene, Mood mood) {
  scene.mood = mood;
  Image& film = scene.image;
  switch (mood) {
    case Mood::none:
      break;
    case Mood::dawn:
      place_sun(scene, 2.0);
      make_hazy(scene, 40000.0);
      scene.sky.cloud_cover = 0.55;
      film.white_balance_k = 5600.0;
      break;
    case Mood::noon:
      place_sun(scene, 58.0);
      scene.sky.cloud_cover = 0.1;
      film.white_balance_k = 5500.0;
      break;
    case Mood::golden:
      place_sun(scene, 6.5);
      make_hazy(scene, 45000.0);
      scene.sky.cloud_cover = 0.35;
      film.white_balance_k = 5700.0;
      film.vignette = 0.12;
      break;
    case Mood::dusk:
      place_sun(scene, -3.0);
      scene.sky.cloud_cover = 0.5;
      film.white_balance_k = 6500.0;
      film.vignette = 0.12;
      break;
    case Mood::night:
      place_sun(scene, -32.0);
      place_moon(scene, 150.0, 36.0);
      scene.sky.cloud_cover = 0.0;
      scene.sky.cumulus.cover = 0.0;
      film.white_balance_k = 5600.0;
      break;
    case Mood::storm:
      make_stormy(scene);
      break;
    case Mood::mist:
      place_sun(scene, 8.0);
      make_hazy(scene, 12000.0);
      make_foggy(scene, 350.0, 120.0);
      scene.sky.cloud_cover = 0.3;
      film.white_balance_k = 6000.0;
      break;
  }
}

void make_basket(Scene& scene) {
  scene.camera.height_above = HeightReference::balloon;
  scene.camera.position.reset();
  scene.camera.target.reset();
  scene.camera.fov_y_deg = 62.0;
}

}  // namespace

Scene defaults(BiomeKind biome, View view, Mood mood) {
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
    case BiomeKind::meadow:
      make_meadow(scene);
      make_outside(scene, {-24.0, -2.0, 84.0}, {15.0, 3.0, 0.0});
      break;
    case BiomeKind::sand:
      make_sand(scene);
      make_outside(scene, {0.0, 8.0, 86.0}, {13.0, 1.0, 0.0});
      break;
  }
  if (view == View::basket) make_basket(scene);
  set_mood(scene, mood);
  set_quality(scene, Quality::standard);
  return scene;
}

void set_elevation(Scene& scene) {
  Terrain& terrain = scene.terrain;
  const Terrain plain;
  terrain.kind = TerrainKind::elevation;
  terrain.cells = 1536;
  terrain.size_m = 60000.0;
  terrain.grading = 30.0;
  terrain.base_m = plain.base_m;
}

void set_season(Scene& scene, Season season) {
  scene.biome.season = season;
  if (scene.biome.kind != BiomeKind::meadow) return;
  Ground& ground = scene.biome.ground;
  switch (season) {
    case Season::spring:
      ground.cover_a = {0.070f, 0.140f, 0.024f};
      ground.cover_b = {0.120f, 0.190f, 0.038f};
      ground.forest = {0.075f, 0.125f, 0.030f};
      ground.field = {0.300f, 0.270f, 0.030f};  // rape in flower
      break;
    case Season::summer:
      ground.cover_a = {0.068f, 0.115f, 0.026f};
      ground.cover_b = {0.130f, 0.160f, 0.046f};
      ground.forest = {0.050f, 0.082f, 0.024f};
      ground.field = {0.330f, 0.245f, 0.090f};
      break;
    case Season::autumn:
      ground.cover_a = {0.095f, 0.112f, 0.034f};
      ground.cover_b = {0.180f, 0.150f, 0.056f};
      ground.forest = {0.105f, 0.072f, 0.024f};
      ground.field = {0.230f, 0.170f, 0.085f};
      break;
  }
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
