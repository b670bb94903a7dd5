#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <string>

#include "geo/transform.hpp"
#include "pictures.hpp"

/// Provides land of small files in UTM zone 32.
namespace aerostat::test {

inline constexpr const char* kCrs = "EPSG:32632";
inline constexpr double kUtmScale = 0.9996;
// On the central meridian of the zone, the local frame has the axes of UTM.
inline constexpr dvec2 kMiddle{500000.0, 5200000.0};

/// Writes an .asc file of side x side samples around kMiddle. `height` has the easting and northing
/// from there.
inline void write_land(const std::filesystem::path& path, int side, double cell,
                       const std::function<double(double east, double north)>& height) {
  std::ofstream file(path);
  const double half = 0.5 * (side - 1) * cell;
  file << std::setprecision(10) << "ncols " << side << "\nnrows " << side << "\nxllcenter "
       << kMiddle.x - half << "\nyllcenter " << kMiddle.y - half << "\ncellsize " << cell << '\n';
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) file << height(i * cell - half, half - j * cell) << ' ';
    file << '\n';
  }
}

/// Returns a square of a file's land around kMiddle, without detail, sea, plants and balloon.
inline scene::Scene bare_land(const std::filesystem::path& path, double size_m, int cells) {
  scene::Scene scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  scene.terrain.kind = scene::TerrainKind::elevation;
  scene.terrain.source = {path.string()};
  scene.terrain.crs = kCrs;
  const geo::Place place = geo::place_of(kCrs, kMiddle);
  scene.terrain.place.latitude_deg = place.latitude_deg;
  scene.terrain.place.longitude_deg = place.longitude_deg;
  scene.terrain.detail = 0.0;
  scene.terrain.size_m = size_m;
  scene.terrain.cells = cells;
  scene.terrain.grading = 1.0;
  scene.biome.water.enabled = false;
  scene.vegetation.enabled = false;
  scene.balloon.enabled = false;
  scene.sky.cumulus.cover = 0.0;
  scene::set_quality(scene, scene::Quality::draft);
  scene.image.spp = 1;
  return scene;
}

}  // namespace aerostat::test
