// How the levels of a drape are made from a picture.
#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "land/drape.hpp"
#include "land/levels_maker.hpp"
#include "land/picture_light.hpp"

namespace aerostat::land {
namespace {

/// A picture as a source of levels.
struct PictureSource {
  using Value = vec4;

  const elevation::Picture& picture;

  const elevation::RasterInfo& info() const { return picture.info(); }
  const std::vector<std::array<int, 2>>& levels() const { return picture.levels(); }
  void read(int level, const elevation::Window& window, vec4* pixels) const {
    picture.read(level, window, pixels);
  }
  static std::uint32_t pack(const vec4& colour) { return packed_texel(colour); }
};

}  // namespace

Drape::Drape(const DrapeOptions& options) {
  constexpr OverlayWords kWords{"picture", "/terrain/drape/crs"};
  const auto picture = elevation::open_picture(options.file, options.picture);
  const Placement placement(picture->info(), options.middle, kWords);
  for (const std::string& note : picture->info().notes) {
    notes_.push_back(options.file.filename().string() + ": " + note);
  }
  const PictureSource source{*picture};
  levels_ = LevelsMaker(source, placement, kWords, options.reach_m,
                        {kLeastDrapeSide, kMostDrapeSide, kMostDrapeLevels})
                .run();
  if (options.lift_shadows > 0.0) lift(options);
}

void Drape::lift(const DrapeOptions& options) {
  const std::string name = options.file.filename().string();
  const double cell_m = options.land->cell_m();
  const auto local = options.land->around(options.middle, options.reach_m);
  const std::optional<PictureLight> light = find_light(levels_, *local, cell_m);
  if (!light) {
    notes_.push_back(name +
                     ": no light and shade of a sun was found in the picture, and none was "
                     "lifted.");
    return;
  }
  lift_light(levels_, *local, cell_m, *light, options.lift_shadows);
  const auto share = [](double correlation) { return 100.0 * correlation * correlation; };
  notes_.push_back(fmt::format(
      "{}: light and shade of a sun at azimuth {:.0f} and {:.0f} degrees high were lifted. They "
      "were {:.0f} % of the variance of brightness, and {:.0f} % of what is left.",
      name, light->azimuth_deg, light->elevation_deg, share(light->correlation),
      share(light_left(levels_, *local, cell_m, *light))));
}

}  // namespace aerostat::land
