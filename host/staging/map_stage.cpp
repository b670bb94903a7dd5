#include "staging/map_stage.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "scene/scene.hpp"
#include "terrain/real_land.hpp"

namespace aerostat::staging {
namespace {

using scene::Override;

// The light of maps: from the upper left, at half of a right angle.
constexpr double kSunAzimuth_deg = 315.0, kSunElevation_deg = 45.0;
// Light and colours of a plain relief, chosen by eye.
constexpr const char* kSky = "[0.35, 0.4, 0.5]";
constexpr const char* kLandAlbedo = "[0.6, 0.58, 0.54]";
constexpr const char* kWaterAlbedo = "[0.32, 0.45, 0.56]";
constexpr const char* kExposure_ev = "-1";
constexpr double kOcclusionCells = 80.0;
// Samples of a geographic grid are narrower than high, and a pixel is finer than their mean so that
// little is lost across. Chosen by eye.
constexpr double kPixelPerSample = 0.8;
constexpr double kMostPixels = 32768.0;  // along a side of a picture
constexpr double kFewestCells = 64.0, kMostCells = 4096.0;
constexpr double kAbove_m = 3000.0;  // height of the camera over the highest land
// The picture is larger than the area, because the rim of a grid may be bent in the local frame,
// and the ground is larger still.
constexpr double kPictureShare = 1.01, kGroundShare = 1.03;
constexpr double kCellsPerSample = 2.0;  // as far as there may be so many cells

class MapStage {
 public:
  MapStage(const scene::SceneSource& source, const land::Land& land)
      : source_(source), land_(land) {
    const scene::Terrain& terrain = source.scene().terrain;
    area_m_ = terrain.extent_m ? dvec2(*terrain.extent_m) : land.size_m();
  }

  scene::SceneSource staged() {
    choose_camera();
    choose_ground();
    choose_light();
    choose_colours();
    for (const char* pointer : {"/balloon/enabled", "/vegetation/enabled"}) set(pointer, "false");
    set("/festival/count", "0");
    return source_.with(changes_);
  }

 private:
  void set(const std::string& pointer, const std::string& value) {
    if (!source_.gives(pointer)) changes_.push_back({pointer, value});
  }

  void choose_camera() {
    const dvec2 size_m = kPictureShare * area_m_;
    const dvec2 pixels = glm::ceil(size_m / (kPixelPerSample * land_.cell_m()));
    if (std::max(pixels.x, pixels.y) > kMostPixels) {
      throw Error(
          ErrorKind::bad_data,
          fmt::format("a map of all files would have {:.0f} x {:.0f} pixels, and a picture "
                      "has at most {:.0f} along a side; choose a part by /terrain/place and "
                      "/terrain/extent_m",
                      pixels.x, pixels.y, kMostPixels));
    }
    set("/camera/lens", "orthographic");
    set("/camera/position", fmt::format("[0, {:.0f}, 0]", land_.highest_m() + kAbove_m));
    set("/camera/target", "[0, 0, 0]");
    set("/camera/up", "[0, 0, -1]");
    set("/camera/height_above", "sea");
    set("/camera/view_height_m", fmt::format("{:.3f}", size_m.y));
    set("/image/width", fmt::format("{:.0f}", pixels.x));
    set("/image/height", fmt::format("{:.0f}", pixels.y));
  }

  void choose_ground() {
    const double side = std::max(area_m_.x, area_m_.y);
    set("/terrain/size_m", fmt::format("{:.0f}", std::ceil(kGroundShare * side)));
    set("/terrain/grading", "1");
    set("/terrain/cells",
        fmt::format("{:.0f}", std::clamp(std::ceil(kCellsPerSample * side / land_.cell_m()),
                                         kFewestCells, kMostCells)));
    set("/terrain/detail", "0");
    set("/terrain/curved", "false");
  }

  /// An even sky has neither air nor clouds, which would lie over the map.
  void choose_light() {
    if (!source_.gives("/sun/date") && !source_.gives("/sun/direction")) {
      set("/sun/azimuth_deg", fmt::format("{}", kSunAzimuth_deg));
      set("/sun/elevation_deg", fmt::format("{}", kSunElevation_deg));
    }
    set("/sky/radiance", kSky);
    set("/sky/occlusion_m",
        fmt::format("{:.0f}", std::clamp(kOcclusionCells * land_.cell_m(), 1.0, 100000.0)));
    set("/sky/bounced_light", "false");
  }

  /// A relief of one colour shows shapes best. Who names a biome or a picture wants to see it.
  void choose_colours() {
    if (source_.gives("/biome/kind") || source_.gives("/terrain/drape/file")) return;
    set("/surfaces", "plain");
    set("/materials/terrain/albedo", kLandAlbedo);
    set("/materials/water/albedo", kWaterAlbedo);
    set("/image/exposure_ev", kExposure_ev);
  }

  const scene::SceneSource& source_;
  const land::Land& land_;
  dvec2 area_m_{0.0};
  std::vector<Override> changes_;
};

}  // namespace

Staged stage_map(const scene::SceneSource& source, terrain::ReliefCache& reliefs) {
  const scene::Scene& scene = source.scene();
  const bool is_view = source.gives("/camera/position") || scene.camera.at;
  if (scene.terrain.kind != scene::TerrainKind::elevation || is_view) {
    return stage(source, reliefs);
  }
  const auto land = terrain::real_land(scene.terrain, reliefs.lands);
  return stage(MapStage(source, *land).staged(), reliefs);
}

}  // namespace aerostat::staging
