#include "elevation/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

#include "core/error.hpp"
#include "elevation/bytes.hpp"
#include "elevation/plausible.hpp"
#include "elevation/reading.hpp"
#include "elevation/side_files.hpp"
#include "geo/transform.hpp"

namespace aerostat::elevation {
namespace {

bool is_tiff(std::span<const std::uint8_t> head) {
  return head.size() >= 4 &&
         (std::memcmp(head.data(), "II*\0", 4) == 0 || std::memcmp(head.data(), "MM\0*", 4) == 0 ||
          std::memcmp(head.data(), "II+\0", 4) == 0 || std::memcmp(head.data(), "MM\0+", 4) == 0);
}

bool is_image(std::span<const std::uint8_t> head) {
  return head.size() >= 4 && (std::memcmp(head.data(), "\x89PNG", 4) == 0 ||
                              std::memcmp(head.data(), "\xff\xd8\xff", 3) == 0);
}

Georeference place_of_corners(const RasterInfo& info, const std::array<geo::Place, 2>& corners) {
  const auto& [from, to] = corners;
  double width_deg = to.longitude_deg - from.longitude_deg;
  if (width_deg < 0.0) width_deg += 360.0;
  const double height_deg = from.latitude_deg - to.latitude_deg;
  if (!(width_deg > 0.0 && width_deg <= 360.0 && height_deg > 0.0)) {
    refuse(info.path,
           "/terrain/drape/corners give no area; the first is expected in the "
           "north-west of the second");
  }
  Georeference place;
  place.crs = "EPSG:4326";
  place.per_column = dvec2(width_deg / info.width, 0.0);
  place.per_row = dvec2(0.0, -height_deg / info.height);
  place.origin =
      dvec2(from.longitude_deg, from.latitude_deg) + 0.5 * (place.per_column + place.per_row);
  return place;
}

void set_place_from_side_files(RasterInfo& info, const PictureOptions& options) {
  const SideFiles beside = side_files_of(info.path);
  if (!beside.world) {
    refuse(info.path,
           fmt::format("this {} does not say where it lies, and no world file (such as .pgw, .jgw "
                       "or .wld) lies beside it; /terrain/drape/corners gives the place of two "
                       "corners",
                       info.format));
  }
  const auto& [a, d, b, e, c, f] = *beside.world;
  if (!(std::abs(a * e - b * d) > 0.0)) {
    refuse(info.path, "the world file beside it gives pixels without an area");
  }
  std::string crs = options.crs.empty() ? crs_of_prj(beside.prj, info.notes) : options.crs;
  if (crs.empty()) crs = beside.aux_wkt;
  info.georeference = Georeference{crs, dvec2(c, f), dvec2(a, d), dvec2(b, e)};
}

}  // namespace

void set_picture_place(RasterInfo& info, const PictureOptions& options) {
  if (options.corners) {
    info.georeference = place_of_corners(info, *options.corners);
  } else if (!info.georeference) {
    set_place_from_side_files(info, options);
  }
  if (!info.georeference->crs.empty()) geo::crs_info(info.georeference->crs);
  require_plausible_place(info, !options.crs.empty() || options.corners.has_value(),
                          "/terrain/drape/crs");
}

float albedo_of_srgb(double share) {
  const double linear = share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  return kWhiteAlbedo * static_cast<float>(linear);
}

std::unique_ptr<Picture> open_picture(const std::filesystem::path& path,
                                      const PictureOptions& options) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) {
    throw Error(ErrorKind::io,
                fmt::format("{}: cannot read the picture: {}", path.string(),
                            code ? code.message() : std::string("it is not a regular file")));
  }
  std::vector<std::uint8_t> head(4);
  const auto bytes = file_bytes(path);
  head.resize(static_cast<std::size_t>(std::min<std::uint64_t>(4, bytes->size())));
  if (!head.empty()) bytes->read(0, head.size(), 1, head);
  if (is_tiff(head)) return open_tiff_picture(path, options);
  if (is_image(head)) return open_image_picture(path, options);
  refuse(path, "this is no picture of a known format; GeoTIFF, PNG or JPEG is expected");
}

}  // namespace aerostat::elevation
