#include "elevation/usgs_dem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "elevation/bytes.hpp"
#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;
// The least length of record A. Later editions have fields behind it.
constexpr std::size_t kRecordA = 864;
// A column has at most this many heights.
constexpr int kMostRows = 1 << 20;

/// Returns a field of fixed width without the spaces around it.
std::string_view field(Bytes bytes, std::size_t at, std::size_t length) {
  if (at >= bytes.size()) return {};
  std::string_view text(reinterpret_cast<const char*>(bytes.data()) + at,
                        std::min(length, bytes.size() - at));
  const auto is_blank = [](char c) { return c >= '\0' && c <= ' '; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<int> whole(Bytes bytes, std::size_t at, std::size_t length) {
  const std::optional<double> value = number_of(field(bytes, at, length));
  if (!value || std::abs(*value) > 1e9 || *value != std::floor(*value)) return std::nullopt;
  return static_cast<int>(*value);
}

bool is_usgs_dem(Bytes head, const std::filesystem::path&) {
  const auto in = [&](std::size_t at, int least, int most) {
    const std::optional<int> value = whole(head, at, 6);
    return value && *value >= least && *value <= most;
  };
  return head.size() >= kRecordA && in(150, 1, 4) && in(156, 0, 99) && in(528, 0, 3) &&
         in(534, 1, 2) && in(540, 4, 4);
}

std::unique_ptr<Raster> open_usgs_dem(const std::filesystem::path& path,
                                      const OpenOptions& options) {
  return read_usgs_dem(read_whole(path, kMostBytes), path, options);
}

/// The numbers of records B. In most files they are fields of fixed width in blocks of 1024 bytes.
/// Long numbers then follow one another without a space. Other files have shorter blocks, in which
/// spaces separate the numbers.
class Fields {
 public:
  enum class Form { blocks, words };

  Fields(Bytes bytes, std::size_t first, Form form, const std::filesystem::path& path)
      : bytes_(bytes), first_(first), at_(first), form_(form), path_(path) {}

  /// Goes to the next block, unless one begins here.
  void begin_record() {
    if (form_ == Form::blocks) at_ = first_ + (at_ - first_ + kBlock - 1) / kBlock * kBlock;
  }

  /// Returns the next number of at most `width` letters, or nothing at the end.
  std::optional<double> next(std::size_t width) {
    std::size_t end = at_ + width;
    if (form_ == Form::words) {
      end = end_of_word(width);
    } else if ((at_ - first_) % kBlock + width > kBlock) {
      begin_record();
      end = at_ + width;
    }
    const std::optional<double> value = number_of(field(bytes_, at_, end - at_));
    if (value) at_ = end;
    return value;
  }

  double required(std::size_t width) {
    const std::optional<double> value = next(width);
    if (!value || !std::isfinite(*value)) {
      refuse(path_, fmt::format("byte {} of the USGS DEM is no part of a number, and one is "
                                "expected",
                                at_));
    }
    return *value;
  }

  std::size_t at() const { return at_; }

 private:
  static constexpr std::size_t kBlock = 1024;

  /// Skips spaces and returns where the number behind them ends. A sign begins another number.
  std::size_t end_of_word(std::size_t width) {
    while (at_ < bytes_.size() && bytes_[at_] <= ' ') ++at_;
    std::size_t end = at_;
    const auto is_sign = [&](std::size_t i) { return bytes_[i] == '-' || bytes_[i] == '+'; };
    while (end < bytes_.size() && end - at_ < width && bytes_[end] > ' ') {
      const bool is_exponent =
          end > at_ && (bytes_[end - 1] | 32) >= 'd' && (bytes_[end - 1] | 32) <= 'e';
      if (end > at_ && is_sign(end) && !is_exponent) break;
      ++end;
    }
    return end;
  }

  Bytes bytes_;
  std::size_t first_, at_;
  Form form_;
  const std::filesystem::path& path_;
};

/// The values of record A, the header of the file.
struct Header {
  int system = 0, zone = 0, ground_unit = 0, height_unit = 0;
  dvec2 spacing{0.0};
  double resolution = 1.0;
  int columns = 0;
  int vertical = 0, datum = 0;  // 0: not said
};

double spacing_at(Bytes bytes, std::size_t at, const std::filesystem::path& path) {
  const std::optional<double> value = number_of(field(bytes, at, 12));
  if (!value || !(*value > 0.0) || !std::isfinite(*value)) {
    refuse(path, fmt::format("the USGS DEM has \"{}\" at byte {}; a resolution above 0 is expected",
                             std::string(field(bytes, at, 12)), at));
  }
  return *value;
}

Header read_header(Bytes bytes, const std::filesystem::path& path) {
  if (!is_usgs_dem(bytes, path)) refuse(path, "record A of a USGS DEM was expected");
  Header header;
  header.system = whole(bytes, 156, 6).value_or(0);
  header.zone = whole(bytes, 162, 6).value_or(0);
  header.ground_unit = whole(bytes, 528, 6).value_or(0);
  header.height_unit = whole(bytes, 534, 6).value_or(2);
  header.spacing = dvec2(spacing_at(bytes, 816, path), spacing_at(bytes, 828, path));
  header.resolution = spacing_at(bytes, 840, path);
  const std::optional<int> columns = whole(bytes, 858, 6);
  if (!columns || *columns < 2) {
    refuse(path, fmt::format("the USGS DEM has \"{}\" columns; at least 2 are expected",
                             std::string(field(bytes, 858, 6))));
  }
  header.columns = *columns;
  return header;
}

/// Returns where the first record B begins. Editions of the format differ in the length of record
/// A.
std::size_t first_record(Bytes bytes, const std::filesystem::path& path) {
  for (const std::size_t at :
       {std::size_t{1024}, kRecordA, std::size_t{893}, std::size_t{896}, std::size_t{918}}) {
    Fields fields(bytes, at, Fields::Form::words, path);
    const auto row = fields.next(6), column = fields.next(6);
    const auto rows = fields.next(6), one = fields.next(6);
    if (row && *row == 1.0 && column && *column <= 1.0 && rows && *rows >= 1.0 && one &&
        *one == 1.0) {
      return at;
    }
  }
  refuse(path, "the USGS DEM has no record B behind its header");
}

/// A column, with its heights as numbers in the file.
struct Column {
  dvec2 first{0.0};  // its southernmost sample
  double datum = 0.0;
  std::vector<float> stored;
};

Column read_column(Fields& fields, const std::filesystem::path& path) {
  fields.begin_record();
  fields.required(6);
  fields.required(6);
  const double rows = fields.required(6);
  const double across = fields.required(6);
  if (!(rows >= 0.0 && rows <= kMostRows) || across != 1.0) {
    refuse(path, fmt::format("a column of the USGS DEM in front of byte {} has {} x {} heights; "
                             "at most {} x 1 are expected",
                             fields.at(), rows, across, kMostRows));
  }
  Column column;
  column.first.x = fields.required(24);
  column.first.y = fields.required(24);
  column.datum = fields.required(24);
  fields.required(24);
  fields.required(24);
  for (int j = 0; j < static_cast<int>(rows); ++j) {
    column.stored.push_back(static_cast<float>(fields.required(6)));
  }
  return column;
}

std::vector<Column> read_columns(Bytes bytes, const Header& header, Fields::Form form,
                                 const std::filesystem::path& path) {
  Fields fields(bytes, first_record(bytes, path), form, path);
  std::vector<Column> columns;
  for (int i = 0; i < header.columns; ++i) columns.push_back(read_column(fields, path));
  return columns;
}

/// Returns the bytes without ends of lines, which some copies have behind blocks.
std::vector<std::uint8_t> without_line_ends(Bytes bytes) {
  std::vector<std::uint8_t> kept;
  kept.reserve(bytes.size());
  std::copy_if(bytes.begin(), bytes.end(), std::back_inserter(kept),
               [](std::uint8_t byte) { return byte != '\r' && byte != '\n'; });
  return kept;
}

std::vector<Column> read_columns(Bytes bytes, const Header& header,
                                 const std::filesystem::path& path) {
  try {
    const bool has_lines = std::find(bytes.begin(), bytes.end(), '\n') != bytes.end();
    const std::vector<std::uint8_t> joined =
        has_lines ? without_line_ends(bytes) : std::vector<std::uint8_t>();
    return read_columns(has_lines ? Bytes(joined) : bytes, header, Fields::Form::blocks, path);
  } catch (const Error&) {
    return read_columns(bytes, header, Fields::Form::words, path);
  }
}

/// Returns the text of the coordinate system, or an empty text if it is none that is known.
std::string crs_of(const Header& header) {
  struct Datum {
    int number, degrees, utm;
  };
  // 3 and 7 were both used for what became WGS 84 and NAD 83.
  constexpr std::array kDatums{Datum{0, 4267, 26700}, Datum{1, 4267, 26700}, Datum{2, 4322, 32200},
                               Datum{3, 4326, 32600}, Datum{4, 4269, 26900}, Datum{7, 4269, 26900}};
  for (const Datum& datum : kDatums) {
    if (datum.number != header.datum) continue;
    if (header.system == 0) return fmt::format("EPSG:{}", datum.degrees);
    const int zone = std::abs(header.zone);
    if (header.system != 1 || zone < 1 || zone > 60) return "";
    if (header.zone > 0) return fmt::format("EPSG:{}", datum.utm + zone);
    return datum.utm == 32600 ? fmt::format("EPSG:{}", 32700 + zone) : "";
  }
  return "";
}

/// Returns the factor that turns coordinates of the file into degrees or metres.
double ground_factor(const Header& header, const std::filesystem::path& path) {
  if (header.ground_unit == 3) return 1.0 / 3600.0;
  if (header.ground_unit == 2) return 1.0;
  if (header.ground_unit == 1) return 1200.0 / 3937.0;
  if (header.system == 0) return 180.0 / 3.14159265358979323846;
  refuse(path, "the USGS DEM has projected coordinates in radians; feet or metres are expected");
}

void set_place(RasterInfo& info, const Header& header, const std::vector<Column>& columns,
               const OpenOptions& options) {
  double south = HUGE_VAL, north = -HUGE_VAL, west = HUGE_VAL, east = -HUGE_VAL;
  std::uint64_t samples = 0;
  for (const Column& column : columns) {
    if (column.stored.empty()) continue;
    const double rows = static_cast<double>(column.stored.size() - 1);
    south = std::min(south, column.first.y);
    north = std::max(north, column.first.y + rows * header.spacing.y);
    west = std::min(west, column.first.x);
    east = std::max(east, column.first.x);
    samples += column.stored.size();
  }
  const double width = std::round((east - west) / header.spacing.x) + 1.0;
  const double height = std::round((north - south) / header.spacing.y) + 1.0;
  if (!(width >= 2.0 && width <= kMostRows && height >= 2.0 && height <= kMostRows) ||
      width * height > 64.0 * static_cast<double>(samples)) {
    refuse(info.path, fmt::format("the columns of the USGS DEM cover {} x {} samples, and only {} "
                                  "heights are given",
                                  width, height, samples));
  }
  require_size(info.path, static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height),
               false);
  info.width = static_cast<int>(width);
  info.height = static_cast<int>(height);
  const double factor = ground_factor(header, info.path);
  Georeference place;
  place.origin = factor * dvec2(west, south + (height - 1.0) * header.spacing.y);
  place.per_column = factor * dvec2(header.spacing.x, 0.0);
  place.per_row = factor * dvec2(0.0, -header.spacing.y);
  place.crs = options.crs.empty() ? crs_of(header) : options.crs;
  info.georeference = place;
}

std::vector<float> grid_of(const RasterInfo& info, const Header& header,
                           const std::vector<Column>& columns, double mark) {
  const auto width = static_cast<std::size_t>(info.width);
  std::vector<float> heights(width * static_cast<std::size_t>(info.height),
                             std::numeric_limits<float>::quiet_NaN());
  double west = HUGE_VAL, south = HUGE_VAL;
  for (const Column& column : columns) {
    if (column.stored.empty()) continue;
    west = std::min(west, column.first.x);
    south = std::min(south, column.first.y);
  }
  for (const Column& column : columns) {
    if (column.stored.empty()) continue;
    const auto i = static_cast<std::size_t>(std::round((column.first.x - west) / header.spacing.x));
    const auto lowest =
        static_cast<std::size_t>(std::round((column.first.y - south) / header.spacing.y));
    for (std::size_t j = 0; j < column.stored.size(); ++j) {
      const double stored = static_cast<double>(column.stored[j]);
      if (stored == mark || stored <= -32767.0) continue;
      // Half samples may be rounded up at both ends.
      const std::size_t row = std::min(lowest + j, static_cast<std::size_t>(info.height) - 1);
      heights[(static_cast<std::size_t>(info.height) - 1 - row) * width + i] =
          static_cast<float>((column.datum + stored * header.resolution) * info.metres_per_unit);
    }
  }
  return heights;
}

void say_what_was_guessed(RasterInfo& info, const Header& header, const OpenOptions& options) {
  if (!options.crs.empty()) return;
  if (info.georeference->crs.empty()) {
    info.notes.push_back(fmt::format(
        "The coordinates are of system {}, zone {}, datum {} of the USGS, which is not known here. "
        "/terrain/crs names the system.",
        header.system, header.zone, header.datum));
  } else if (header.datum == 0) {
    info.notes.emplace_back(
        "The file does not say its datum, and NAD27 was taken, as its age says.");
  }
}

}  // namespace

const Format kUsgsDemFormat{"USGS DEM", is_usgs_dem, open_usgs_dem};

std::unique_ptr<Raster> read_usgs_dem(Bytes bytes, const std::filesystem::path& path,
                                      const OpenOptions& options) {
  Header header = read_header(bytes, path);
  const std::vector<Column> columns = read_columns(bytes, header, path);
  // The fields of later editions lie behind byte 864, and only if the record is that long.
  if (first_record(bytes, path) > kRecordA) {
    header.vertical = whole(bytes, 888, 2).value_or(0);
    header.datum = whole(bytes, 890, 2).value_or(0);
  }
  RasterInfo info;
  info.path = path;
  info.format = "USGS DEM";
  info.sample_type = header.resolution == 1.0 ? "int16" : "float32";
  constexpr std::array kVertical{"", "mean sea level", "NGVD29", "NAVD88"};
  if (header.vertical >= 1 && header.vertical <= 3) {
    info.vertical_datum = kVertical[static_cast<std::size_t>(header.vertical)];
  }
  set_place(info, header, columns, options);
  set_unit(info, options, header.height_unit == 1 ? 0.3048 : 1.0,
           header.height_unit == 1 ? "foot" : "metre");
  say_what_was_guessed(info, header, options);
  std::vector<float> heights = grid_of(info, header, columns, options.nodata.value_or(-32767.0));
  return std::make_unique<MemoryRaster>(std::move(info), std::move(heights));
}

}  // namespace aerostat::elevation
