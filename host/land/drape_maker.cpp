// How the levels of a drape are made from a picture.
#include <algorithm>

#include "land/drape.hpp"
#include "land/levels_maker.hpp"

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
  const PictureSource source{*picture};
  levels_ = LevelsMaker(source, placement, kWords, options.reach_m,
                        {kLeastDrapeSide, kMostDrapeSide, kMostDrapeLevels})
                .run();
}

}  // namespace aerostat::land
