#include "elevation/images.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "elevation/reading.hpp"

namespace aerostat::elevation {

HeightScale height_scale_of(RasterInfo& info, const OpenOptions& options, double lowest,
                            double highest, bool may_be_metres) {
  set_unit(info, options, 1.0, "metre");
  if (options.image_heights_m) {
    const auto [low, high] = *options.image_heights_m;
    if (!std::isfinite(low) || !std::isfinite(high) || !(low < high)) {
      refuse(info.path, fmt::format("/terrain/image_heights_m is [{}, {}]; the lower height is "
                                    "expected first",
                                    low, high));
    }
    set_unit(info, {}, 1.0, "metre");
    const double scale = (high - low) / (highest - lowest);
    return {scale, low - scale * lowest};
  }
  if (!may_be_metres && !options.metres_per_unit) {
    refuse(info.path,
           fmt::format("the values of this {} go from {} to {} and say nothing of heights; "
                       "/terrain/image_heights_m is needed, [lowest, highest] in metres{}",
                       info.format, lowest, highest,
                       options.cell_m ? "" : ", and /terrain/cell_m, the distance of samples"));
  }
  return {info.metres_per_unit, 0.0};
}

void set_image_place(RasterInfo& info, const OpenOptions& options, const SideFiles& beside) {
  if (beside.world && !options.cell_m) {
    const auto [a, d, b, e, c, f] = *beside.world;
    Georeference place;
    place.per_column = dvec2(a, d);
    place.per_row = dvec2(b, e);
    place.origin = dvec2(c, f);
    if (!(std::abs(a * e - b * d) > 0.0)) {
      refuse(info.path, "the world file beside it gives samples without an area");
    }
    place.crs = options.crs.empty() ? crs_of_prj(beside.prj, info.notes) : options.crs;
    info.georeference = place;
    say_if_without_crs(info);
    return;
  }
  if (!options.cell_m) {
    refuse(info.path, fmt::format("this {} says nothing of distances; /terrain/cell_m is needed, "
                                  "the distance of samples in metres",
                                  info.format));
  }
  info.georeference = place_without_earth(info, options);
}

void say_if_without_crs(RasterInfo& info) {
  if (!info.georeference || !info.georeference->crs.empty()) return;
  info.notes.emplace_back(
      "The file does not say its coordinate reference system, and no .prj file beside it does. "
      "/terrain/crs names it.");
}

}  // namespace aerostat::elevation
