#include "elevation/geotiff_info.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "elevation/gdal_metadata.hpp"
#include "elevation/height_unit.hpp"
#include "elevation/reading.hpp"
#include "elevation/tiff_tags.hpp"

namespace aerostat::elevation {
namespace {

void set_nodata(const TiffHandle& handle, const OpenOptions& options, RasterInfo& info,
                HeightRule& rule) {
  if (options.nodata) {
    rule.nodata = Nodata{fmt::format("{}", *options.nodata)};
    return;
  }
  std::string text = text_of(handle, kTagGdalNodata);
  text.erase(0, text.find_first_not_of(" \t\r\n"));
  text.resize(text.find_last_not_of(" \t\r\n") + 1);
  if (text.empty()) return;
  rule.nodata = Nodata{text};
  if (rule.nodata->fits(rule.type)) return;
  if (is_float(rule.type) || number_of(text).has_value()) {
    const std::string lower = lower_case(text);
    if (lower.find("nan") != std::string::npos) return;  // no number is a void in any case
    info.notes.push_back(
        fmt::format("The file marks samples without a height by {}, which samples of its type "
                    "({}) cannot be.",
                    text.substr(0, 40), name_of(rule.type)));
  }
  rule.nodata.reset();
}

/// Sets the unit of heights to what is said by, in turn, the user, the vertical system and the
/// metadata. The unit of horizontal coordinates says nothing of it.
void set_height_unit(const GdalMetadata& metadata, double vertical_unit, const OpenOptions& options,
                     RasterInfo& info) {
  if (vertical_unit > 0.0) {
    const auto known = height_unit_of(vertical_unit);
    set_unit(info, options, vertical_unit,
             known ? std::string(known->name) : fmt::format("{} m", vertical_unit));
    return;
  }
  const auto known = height_unit_of(metadata.unit);
  set_unit(info, options, known ? known->metres : 1.0, known ? known->name : "metre");
  if (options.metres_per_unit || options.image_heights_m || known) return;
  info.notes.push_back(
      metadata.unit.empty()
          ? std::string("Heights are taken as metres because the file gives no unit.")
          : fmt::format("Heights are taken as metres because their unit \"{}\" is unknown.",
                        metadata.unit.substr(0, 40)));
}

void set_scale(const GdalMetadata& metadata, const OpenOptions& options, RasterInfo& info,
               HeightRule& rule) {
  rule.metres_per_unit = info.metres_per_unit;
  if (options.image_heights_m) {
    const auto [low_m, high_m] = *options.image_heights_m;
    const double range = highest_of(rule.type) - lowest_of(rule.type);
    rule.scale = (high_m - low_m) / range;
    rule.offset = low_m - lowest_of(rule.type) * rule.scale;
    rule.metres_per_unit = 1.0;
    return;
  }
  rule.scale = metadata.scale.value_or(1.0);
  rule.offset = metadata.offset.value_or(0.0);
  if (rule.scale == 1.0 && rule.offset == 0.0) return;
  info.notes.push_back(
      fmt::format("The file says that a height is the stored number times {} plus {}.", rule.scale,
                  rule.offset));
}

void note_pages(const TiffPages& pages, RasterInfo& info) {
  if (pages.main.layout.bands > (pages.main.layout.opacity > 0 ? 2 : 1)) {
    info.notes.push_back(
        fmt::format("The file has {} bands, of which the first one is taken as heights.",
                    pages.main.layout.bands));
  }
  if (pages.others > 0) {
    info.notes.push_back(
        fmt::format("The file has {} pages, of which the first one is read.", pages.others + 1));
  }
}

}  // namespace

GeoTiffInfo geotiff_info(const TiffHandle& handle, const TiffPages& pages,
                         const OpenOptions& options) {
  const std::filesystem::path& shown = handle.path();
  GeoTiffInfo result;
  RasterInfo& info = result.info;
  const GdalMetadata metadata = gdal_metadata_of(text_of(handle, kTagGdalMetadata));
  result.rule.type = pages.main.layout.sample;
  if (metadata.signed_bytes && result.rule.type == TiffSample::uint8) {
    result.rule.type = TiffSample::int8;
  }
  info.path = shown;
  info.format = "GeoTIFF";
  info.sample_type = name_of(result.rule.type);
  info.width = pages.main.layout.width;
  info.height = pages.main.layout.height;
  if (metadata.thematic && !options.codes)
    refuse(shown, "this is a map of classes, not of heights");
  require_size(shown, static_cast<std::uint64_t>(info.width),
               static_cast<std::uint64_t>(info.height), true);
  double vertical_unit = 0.0;
  set_place(handle, options, info, vertical_unit);
  set_nodata(handle, options, info, result.rule);
  if (!options.codes) {
    set_height_unit(metadata, vertical_unit, options, info);
    set_scale(metadata, options, info, result.rule);
  }
  note_pages(pages, info);
  return result;
}

}  // namespace aerostat::elevation
