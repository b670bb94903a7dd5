#include "elevation/dted.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "elevation/bytes.hpp"
#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 29;
// The lengths of the records of the header.
constexpr std::size_t kUhl = 80, kDsi = 648, kAcc = 2700;
// The bytes of a data record in front of its heights and behind them.
constexpr std::size_t kHead = 8, kChecksum = 4;

std::string_view text_at(Bytes bytes, std::size_t at, std::size_t length) {
  return {reinterpret_cast<const char*>(bytes.data()) + at, length};
}

/// Returns where the header begins. Files from tapes have one or two labels in front of it.
std::optional<std::size_t> header_of(Bytes bytes) {
  for (const std::size_t at : {std::size_t{0}, kUhl, 2 * kUhl}) {
    if (bytes.size() >= at + kUhl && text_at(bytes, at, 4) == "UHL1") return at;
  }
  return std::nullopt;
}

bool is_dted(Bytes head, const std::filesystem::path&) {
  return header_of(head).has_value();
}

std::unique_ptr<Raster> open_dted(const std::filesystem::path& path, const OpenOptions& options) {
  return read_dted(read_whole(path, kMostBytes), path, options);
}

/// Returns a field of digits.
double digits(Bytes bytes, std::size_t at, std::size_t length, const std::filesystem::path& path) {
  double value = 0.0;
  for (const char c : text_at(bytes, at, length)) {
    if (c < '0' || c > '9') {
      refuse(path, fmt::format("the header of the DTED file has \"{}\" at byte {}; digits are "
                               "expected",
                               std::string(text_at(bytes, at, length)), at));
    }
    value = 10.0 * value + (c - '0');
  }
  return value;
}

/// Returns an angle in degrees from a field of the form DDDMMSSH.
double angle(Bytes bytes, std::size_t at, const std::filesystem::path& path) {
  const double degrees = digits(bytes, at, 3, path) + digits(bytes, at + 3, 2, path) / 60.0 +
                         digits(bytes, at + 5, 2, path) / 3600.0;
  const char hemisphere = static_cast<char>(bytes[at + 7]);
  if (std::string_view("NSEW").find(hemisphere) == std::string_view::npos || degrees > 180.0) {
    refuse(path, fmt::format("the header of the DTED file has \"{}\" at byte {}; an angle such as "
                             "0460000N is expected",
                             std::string(text_at(bytes, at, 8)), at));
  }
  return hemisphere == 'S' || hemisphere == 'W' ? -degrees : degrees;
}

void read_header(RasterInfo& info, Bytes bytes, std::size_t at, const OpenOptions& options) {
  const std::filesystem::path& path = info.path;
  const auto width = static_cast<std::uint64_t>(digits(bytes, at + 47, 4, path));
  const auto height = static_cast<std::uint64_t>(digits(bytes, at + 51, 4, path));
  require_size(path, width, height, false);
  info.width = static_cast<int>(width);
  info.height = static_cast<int>(height);
  const double tenth_of_second = 1.0 / 36000.0;
  Georeference place;
  place.per_column = dvec2(digits(bytes, at + 20, 4, path) * tenth_of_second, 0.0);
  place.per_row = dvec2(0.0, -digits(bytes, at + 24, 4, path) * tenth_of_second);
  if (place.per_column.x <= 0.0 || place.per_row.y >= 0.0) {
    refuse(path, "the header of the DTED file has samples that are 0 seconds of arc apart");
  }
  const double west = angle(bytes, at + 4, path), south = angle(bytes, at + 12, path);
  place.origin = dvec2(west, south - (info.height - 1) * place.per_row.y);
  const std::string_view datum = text_at(bytes, at + kUhl + 144, 5);
  place.crs = datum == "WGS72" ? "EPSG:4322" : "EPSG:4326";
  if (datum != "WGS84" && datum != "WGS72") {
    info.notes.emplace_back("The file names no known datum, and WGS 84 was taken.");
  }
  if (!options.crs.empty()) place.crs = options.crs;
  info.georeference = place;
  const std::string_view vertical = text_at(bytes, at + kUhl + 141, 3);
  info.vertical_datum = vertical == "E96"   ? "EGM96 height"
                        : vertical == "MSL" ? "mean sea level"
                                            : "";
}

/// Faults that were counted while heights were read.
struct Seen {
  int wrong_sums = 0, complements = 0;
};

/// Returns the height of two bytes. Some programs write negative numbers as complements instead of
/// with a sign bit, which gives depths that no place on the Earth has.
float height_of(std::uint8_t high, std::uint8_t low, double mark, double factor, Seen& seen) {
  int stored = (high & 0x7f) << 8 | low;
  if ((high & 0x80) != 0) stored = -stored;
  if (stored == -32767 || stored == mark) return std::numeric_limits<float>::quiet_NaN();
  if (stored < -16000) {
    stored = ((high << 8 | low) ^ 0x8000) - 0x8000;
    ++seen.complements;
  }
  return static_cast<float>(stored * factor);
}

/// Returns whether the sum of all bytes of a record is the one at its end.
bool has_right_sum(Bytes record) {
  std::uint32_t sum = 0, stored = 0;
  for (const std::uint8_t byte : record.first(record.size() - kChecksum)) sum += byte;
  for (const std::uint8_t byte : record.last(kChecksum)) stored = stored << 8 | byte;
  return sum == stored;
}

std::vector<float> read_columns(const RasterInfo& info, Bytes columns, double mark, Seen& seen) {
  const auto width = static_cast<std::size_t>(info.width);
  const auto height = static_cast<std::size_t>(info.height);
  const std::size_t length = kHead + 2 * height + kChecksum;
  std::vector<float> heights(width * height);
  for (std::size_t i = 0; i < width; ++i) {
    const Bytes record = columns.subspan(i * length, length);
    if (record[0] != 0xAA) {
      refuse(info.path, fmt::format("column {} of the DTED file begins with byte {}; 170 is "
                                    "expected",
                                    i + 1, record[0]));
    }
    if (!has_right_sum(record)) ++seen.wrong_sums;
    for (std::size_t j = 0; j < height; ++j) {
      heights[(height - 1 - j) * width + i] = height_of(
          record[kHead + 2 * j], record[kHead + 2 * j + 1], mark, info.metres_per_unit, seen);
    }
  }
  return heights;
}

}  // namespace

const Format kDtedFormat{"DTED", is_dted, open_dted};

std::unique_ptr<Raster> read_dted(Bytes bytes, const std::filesystem::path& path,
                                  const OpenOptions& options) {
  RasterInfo info;
  info.path = path;
  info.format = "DTED";
  info.sample_type = "int16";
  const std::optional<std::size_t> at = header_of(bytes);
  if (!at) refuse(path, "the header of a DTED file (UHL1) was expected");
  const std::size_t first = *at + kUhl + kDsi + kAcc;
  if (bytes.size() < first) {
    refuse(path, fmt::format("the DTED file has {} bytes, and its header alone has {}",
                             bytes.size(), first));
  }
  read_header(info, bytes, *at, options);
  set_unit(info, options, 1.0, "metre");
  const std::size_t needed = static_cast<std::size_t>(info.width) *
                             (kHead + 2 * static_cast<std::size_t>(info.height) + kChecksum);
  if (bytes.size() - first < needed) {
    refuse(path, fmt::format("the DTED file has {} bytes, and {} x {} heights need {}; it is cut "
                             "short",
                             bytes.size(), info.width, info.height, first + needed));
  }
  Seen seen;
  std::vector<float> heights =
      read_columns(info, bytes.subspan(first, needed), options.nodata.value_or(-32767.0), seen);
  if (seen.wrong_sums > 0) {
    info.notes.push_back(fmt::format(
        "The checksum of {} of {} columns is wrong, and their heights were read all the same.",
        seen.wrong_sums, info.width));
  }
  if (seen.complements > 0) {
    info.notes.push_back(fmt::format(
        "{} heights below -16000 m were read as two's complements, which some programs write "
        "against the rules of DTED.",
        seen.complements));
  }
  return std::make_unique<MemoryRaster>(std::move(info), std::move(heights));
}

}  // namespace aerostat::elevation
