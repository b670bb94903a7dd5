#include "elevation/bil.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "elevation/images.hpp"
#include "elevation/reading.hpp"
#include "elevation/sample_raster.hpp"

namespace aerostat::elevation {
namespace {

std::unique_ptr<Raster> open_bil(const std::filesystem::path& path, const OpenOptions& options) {
  return read_bil(file_bytes(path), side_files_of(path), path, options);
}

bool is_bil(std::span<const std::uint8_t>, const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (ending == ".bil" || ending == ".flt") return true;
  return ending == ".dem" && !side_files_of(path).hdr.empty();
}

/// The words behind the keys of a .hdr file, in lower case.
class HdrFile {
 public:
  HdrFile(const std::string& text, const std::filesystem::path& path) : path_(path) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream parts(line);
      std::string key, value;
      if (parts >> key >> value) values_.emplace(lower_case(key), lower_case(value));
    }
  }

  std::string text(const std::string& key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? "" : found->second;
  }

  std::optional<double> number(const std::string& key) const {
    const std::string value = text(key);
    if (value.empty()) return std::nullopt;
    const std::optional<double> parsed = number_of(value);
    if (!parsed || !std::isfinite(*parsed)) {
      refuse(path_, fmt::format("the .hdr file beside it has \"{}\" for {}; a number is expected",
                                value.substr(0, 40), key));
    }
    return parsed;
  }

  std::uint64_t count(const std::string& key, std::optional<std::uint64_t> otherwise) const {
    const std::optional<double> value = number(key);
    if (!value && otherwise) return *otherwise;
    if (!value || *value < 0.0 || *value > 1e15 || *value != std::floor(*value)) {
      refuse(path_, fmt::format("the .hdr file beside it has \"{}\" for {}; a count is expected",
                                text(key).substr(0, 40), key));
    }
    return static_cast<std::uint64_t>(*value);
  }

 private:
  const std::filesystem::path& path_;
  std::map<std::string, std::string> values_;
};

SampleType type_of(const HdrFile& hdr, RasterInfo& info) {
  const bool is_flt = ending_of(info.path) == ".flt";
  const std::uint64_t bits = hdr.count("nbits", is_flt ? 32 : 8);
  const std::string pixels = hdr.text("pixeltype");
  if (is_flt || pixels == "float") {
    if (bits == 32) return SampleType::float32;
    if (bits == 64) return SampleType::float64;
  } else if (bits == 16) {
    if (pixels.empty()) {
      info.notes.emplace_back(
          "The .hdr file does not say whether heights are signed, and signed ones were taken.");
    }
    return pixels.starts_with("unsigned") ? SampleType::uint16 : SampleType::int16;
  } else if (bits == 32) {
    return pixels.starts_with("unsigned") ? SampleType::uint32 : SampleType::int32;
  } else if (bits == 8) {
    return pixels.starts_with("signed") ? SampleType::int8 : SampleType::uint8;
  }
  refuse(info.path, fmt::format("the .hdr file beside it says {} bits of type \"{}\"; 8, 16, 32 or "
                                "64 bits are expected",
                                bits, pixels));
}

/// Returns the place that the header gives in one of its two forms, or nothing.
std::optional<Georeference> place_of(const HdrFile& hdr, const RasterInfo& info) {
  Georeference place;
  const auto cell = hdr.number("cellsize");
  const double dx = hdr.number("xdim").value_or(cell.value_or(0.0));
  const double dy = hdr.number("ydim").value_or(cell.value_or(0.0));
  if (!(dx > 0.0 && dy > 0.0)) return std::nullopt;
  place.per_column = dvec2(dx, 0.0);
  place.per_row = dvec2(0.0, -dy);
  const auto left = hdr.number("ulxmap"), top = hdr.number("ulymap");
  if (left && top) {
    place.origin = dvec2(*left, *top);
    return place;
  }
  const auto west = hdr.number("xllcorner"), south = hdr.number("yllcorner");
  const auto first_x = hdr.number("xllcenter"), last_y = hdr.number("yllcenter");
  if ((!west && !first_x) || (!south && !last_y)) return std::nullopt;
  place.origin = dvec2(first_x ? *first_x : *west + 0.5 * dx,
                       (last_y ? *last_y : *south + 0.5 * dy) + dy * (info.height - 1));
  return place;
}

void set_place(RasterInfo& info, const HdrFile& hdr, const SideFiles& beside,
               const OpenOptions& options) {
  info.georeference = place_of(hdr, info);
  if (!info.georeference) {
    set_image_place(info, options, beside);
    return;
  }
  info.georeference->crs = options.crs.empty() ? crs_of_prj(beside.prj, info.notes) : options.crs;
  say_if_without_crs(info);
}

SampleLayout layout_of(const HdrFile& hdr, RasterInfo& info, const OpenOptions& options) {
  SampleLayout layout;
  layout.type = type_of(hdr, info);
  const std::string order = hdr.text("byteorder");
  layout.big_endian = order.starts_with("m");
  layout.first = hdr.count("skipbytes", 0);
  const std::uint64_t row =
      static_cast<std::uint64_t>(bytes_of(layout.type)) * static_cast<std::uint64_t>(info.width);
  layout.row_stride = hdr.count("totalrowbytes", row);
  if (layout.row_stride < row) {
    refuse(info.path, fmt::format("the .hdr file beside it says rows of {} bytes, and {} samples "
                                  "need {}",
                                  layout.row_stride, info.width, row));
  }
  std::optional<double> mark = options.nodata;
  if (!mark) mark = hdr.number("nodata");
  if (!mark) mark = hdr.number("nodata_value");
  layout.voids.push_back(mark.value_or(-9999.0));
  layout.scale = info.metres_per_unit;
  return layout;
}

}  // namespace

const Format kBilFormat{"grid with a .hdr file", is_bil, open_bil};

std::unique_ptr<Raster> read_bil(std::shared_ptr<const ByteSource> bytes, const SideFiles& beside,
                                 const std::filesystem::path& path, const OpenOptions& options) {
  RasterInfo info;
  info.path = path;
  info.format = "grid with a .hdr file";
  if (beside.hdr.empty()) {
    refuse(path, "the .hdr file that describes its samples does not lie beside it");
  }
  const HdrFile hdr(beside.hdr, path);
  const std::uint64_t width = hdr.count("ncols", std::nullopt);
  const std::uint64_t height = hdr.count("nrows", std::nullopt);
  require_size(path, width, height, true);
  if (hdr.count("nbands", 1) != 1) {
    refuse(path, fmt::format("the .hdr file beside it says {} bands; 1 is expected",
                             hdr.count("nbands", 1)));
  }
  info.width = static_cast<int>(width);
  info.height = static_cast<int>(height);
  set_unit(info, options, 1.0, "metre");
  SampleLayout layout = layout_of(hdr, info, options);
  info.sample_type = name_of(layout.type);
  const std::uint64_t row = width * static_cast<std::uint64_t>(bytes_of(layout.type));
  const std::uint64_t needed = layout.row_stride > bytes->size()
                                   ? layout.row_stride
                                   : layout.first + (height - 1) * layout.row_stride + row;
  if (bytes->size() < needed) {
    refuse(path, fmt::format("the file has {} bytes, and {} x {} samples of {} need {}",
                             bytes->size(), width, height, info.sample_type, needed));
  }
  set_place(info, hdr, beside, options);
  return std::make_unique<SampleRaster>(std::move(info), std::move(bytes), std::move(layout));
}

}  // namespace aerostat::elevation
