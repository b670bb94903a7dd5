#pragma once

#include <concepts>

#include "scene/scene.hpp"

/// These functions list the fields of the scene's structs with their JSON keys, once for reading
/// and writing. An archive is called as `archive("key", field)`, in the order of the file.
namespace aerostat::scene::detail {

template <class Archive>
void fields(Archive& archive, Fractal& fractal) {
  archive("kind", fractal.kind);
  archive("octaves", fractal.octaves);
  archive("lacunarity", fractal.lacunarity);
  archive("gain", fractal.gain);
  archive("ridge_offset", fractal.ridge_offset);
}

template <class Archive>
void fields(Archive& archive, Dunes& dunes) {
  archive("wind_deg", dunes.wind_deg);
  archive("wavelength_m", dunes.wavelength_m);
  archive("height_m", dunes.height_m);
}

template <class Archive>
void fields(Archive& archive, Terrain& terrain) {
  archive("kind", terrain.kind);
  archive("seed", terrain.seed);
  archive("cells", terrain.cells);
  archive("size_m", terrain.size_m);
  archive("center", terrain.center);
  archive("grading", terrain.grading);
  archive("height_m", terrain.height_m);
  archive("base_m", terrain.base_m);
  archive("feature_m", terrain.feature_m);
  archive("warp_m", terrain.warp_m);
  archive("warp_feature_m", terrain.warp_feature_m);
  archive("sharpness", terrain.sharpness);
  archive("erosion", terrain.erosion);
  archive("fractal", terrain.fractal);
  archive("dunes", terrain.dunes);
}

template <class Archive>
void fields(Archive& archive, Ground& ground) {
  archive("cover_a", ground.cover_a);
  archive("cover_b", ground.cover_b);
  archive("rock_a", ground.rock_a);
  archive("rock_b", ground.rock_b);
  archive("rock_slope_deg", ground.rock_slope_deg);
  archive("snow", ground.snow);
  archive("snow_line_m", ground.snow_line_m);
  archive("snow_fuzz_m", ground.snow_fuzz_m);
  archive("snow_slope_deg", ground.snow_slope_deg);
  archive("beach", ground.beach);
  archive("beach_top_m", ground.beach_top_m);
  archive("pattern_m", ground.pattern_m);
  archive("relief", ground.relief);
  archive("ripple_m", ground.ripple_m);
  archive("strata_m", ground.strata_m);
  archive("softness", ground.softness);
  archive("sparkle", ground.sparkle);
  archive("forest", ground.forest);
  archive("forest_top_m", ground.forest_top_m);
  archive("forest_share", ground.forest_share);
  archive("canopy_m", ground.canopy_m);
}

template <class Archive>
void fields(Archive& archive, Water& water) {
  archive("enabled", water.enabled);
  archive("level_m", water.level_m);
  archive("absorption_per_m", water.absorption_per_m);
  archive("scatter", water.scatter);
  archive("bed", water.bed);
  archive("wave_m", water.wave_m);
  archive("wave_slope", water.wave_slope);
}

template <class Archive>
void fields(Archive& archive, Biome& biome) {
  archive("kind", biome.kind);
  archive("ground", biome.ground);
  archive("water", biome.water);
}

template <class Archive>
void fields(Archive& archive, Vegetation& vegetation) {
  archive("enabled", vegetation.enabled);
  archive("density", vegetation.density);
  archive("size", vegetation.size);
  archive("reach_m", vegetation.reach_m);
  archive("seed", vegetation.seed);
}

template <class Archive>
void fields(Archive& archive, Balloon& balloon) {
  archive("enabled", balloon.enabled);
  archive("position", balloon.position);
  archive("height_above", balloon.height_above);
  archive("diameter_m", balloon.diameter_m);
  archive("heading_deg", balloon.heading_deg);
  archive("gores", balloon.gores);
  archive("burner", balloon.burner);
  archive("pattern", balloon.pattern);
  archive("palette", balloon.palette);
  archive("colors", balloon.colors);
}

template <class Archive>
void fields(Archive& archive, Camera& camera) {
  archive("view", camera.view);
  archive("position", camera.position, camera.position_given);
  archive("target", camera.target, camera.target_given);
  archive("height_above", camera.height_above);
  archive("up", camera.up);
  archive("lens", camera.lens);
  archive("fov_y_deg", camera.fov_y_deg);
  archive("f_number", camera.f_number);
  archive("aperture_m", camera.aperture_m, camera.aperture_given);
  archive("focus_m", camera.focus_m, camera.focus_given);
  archive("view_height_m", camera.view_height_m);
}

template <class Archive>
void fields(Archive& archive, Sun& sun) {
  archive("direction", sun.direction);
  archive("color", sun.color);
  archive("irradiance", sun.irradiance);
  archive("shadows", sun.shadows);
  archive("soft_shadows", sun.soft_shadows);
}

template <class Archive>
void fields(Archive& archive, PointLight& light) {
  archive("position", light.position);
  archive("color", light.color);
  archive("intensity", light.intensity);
  archive("shadows", light.shadows);
}

template <class Archive>
void fields(Archive& archive, Cumulus& cumulus) {
  archive("cover", cumulus.cover);
  archive("base_m", cumulus.base_m);
  archive("thickness_m", cumulus.thickness_m);
  archive("size_m", cumulus.size_m);
  archive("seed", cumulus.seed);
}

template <class Archive>
void fields(Archive& archive, Sky& sky) {
  archive("cloud_cover", sky.cloud_cover);
  archive("cloud_height_m", sky.cloud_height_m);
  archive("ambient_occlusion", sky.ambient_occlusion);
  archive("occlusion_m", sky.occlusion_m);
  archive("bounced_light", sky.bounced_light);
  archive("cumulus", sky.cumulus);
}

template <class Archive>
void fields(Archive& archive, Air& air) {
  archive("density", air.density);
  archive("ozone_du", air.ozone_du);
  archive("ground_albedo", air.ground_albedo);
}

template <class Archive>
void fields(Archive& archive, Haze& haze) {
  archive("visibility_m", haze.visibility_m);
  archive("scale_height_m", haze.scale_height_m);
  archive("angstrom", haze.angstrom);
  archive("asymmetry", haze.asymmetry);
  archive("albedo", haze.albedo);
}

template <class Archive>
void fields(Archive& archive, Fog& fog) {
  archive("enabled", fog.enabled);
  archive("visibility_m", fog.visibility_m);
  archive("top_m", fog.top_m);
  archive("softness_m", fog.softness_m);
  archive("billow_m", fog.billow_m);
  archive("billow_width_m", fog.billow_width_m);
}

template <class Archive>
void fields(Archive& archive, Material& material) {
  archive("albedo", material.albedo);
  archive("ambient", material.ambient);
  archive("diffuse", material.diffuse);
  archive("specular", material.specular);
  archive("shininess", material.shininess);
  archive("translucency", material.translucency);
  archive("emission", material.emission);
}

/// Passes all materials by their names.
template <class Archive>
void fields(Archive& archive, std::array<Material, kMaterialCount>& materials) {
  for (std::size_t i = 0; i < kMaterialCount; ++i) {
    archive(material_name(static_cast<MaterialId>(i)).c_str(), materials[i]);
  }
}

template <class Archive>
void fields(Archive& archive, Image& image) {
  archive("width", image.width);
  archive("height", image.height);
  archive("spp", image.spp);
  archive("adaptive_threshold", image.adaptive_threshold);
  archive("seed", image.seed);
  archive("filter", image.filter);
  archive("exposure_ev", image.exposure_ev, image.exposure_given);
  archive("white_balance_k", image.white_balance_k, image.white_balance_given);
  archive("vignette", image.vignette);
}

template <class Archive>
void fields(Archive& archive, Scene& scene) {
  archive("biome", scene.biome);
  archive("terrain", scene.terrain);
  archive("vegetation", scene.vegetation);
  archive("balloon", scene.balloon);
  archive("balloons", scene.balloons);
  archive("camera", scene.camera);
  archive("sun", scene.sun);
  archive("lights", scene.lights);
  archive("sky", scene.sky);
  archive("air", scene.air);
  archive("haze", scene.haze);
  archive("fog", scene.fog);
  archive("materials", scene.materials);
  archive("shading", scene.shading);
  archive("quality", scene.quality);
  archive("image", scene.image);
}

}  // namespace aerostat::scene::detail
