#include "elevation/asc.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "elevation/asc_raster.hpp"
#include "elevation/images.hpp"
#include "elevation/reading.hpp"
#include "elevation/words.hpp"

namespace aerostat::elevation {
namespace {

constexpr std::array kKeys{"ncols",     "nrows",    "xllcorner", "xllcenter", "yllcorner",
                           "yllcenter", "cellsize", "dx",        "dy",        "nodata_value"};

/// The values of the header in the order of kKeys.
struct Header {
  std::array<std::optional<double>, kKeys.size()> values;

  std::optional<double> operator[](std::string_view key) const {
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
      if (key == kKeys[i]) return values[i];
    }
    return std::nullopt;
  }
};

std::optional<std::size_t> key_of(std::string_view word) {
  const std::string key = lower_case(word);
  for (std::size_t i = 0; i < kKeys.size(); ++i) {
    if (key == kKeys[i]) return i;
  }
  if (key == "nodata" || key == "nodatavalue") return kKeys.size() - 1;
  if (key == "xllcentre") return 3;
  if (key == "yllcentre") return 5;
  return std::nullopt;
}

bool is_asc(std::span<const std::uint8_t> head, const std::filesystem::path&) {
  std::size_t i = head.size() >= 3 && head[0] == 0xEF && head[1] == 0xBB ? 3 : 0;
  while (i < head.size() && head[i] <= ' ') ++i;
  std::string word;
  while (i < head.size() && head[i] > ' ' && word.size() < 16) word += static_cast<char>(head[i++]);
  return key_of(word).has_value();
}

std::unique_ptr<Raster> open_asc(const std::filesystem::path& path, const OpenOptions& options) {
  return read_asc(file_bytes(path), side_files_of(path), path, options);
}

double header_number(std::string_view word, const char* key, const std::filesystem::path& path) {
  const std::optional<double> value = number_of(word);
  const bool may_be_void = std::string_view(key) == "nodata_value";
  if (may_be_void && is_void_word(word)) return std::numeric_limits<double>::quiet_NaN();
  if (!value || !std::isfinite(*value)) {
    refuse(path, fmt::format("the header has \"{}\" for {}; a number is expected",
                             std::string(word.substr(0, 40)), key));
  }
  return *value;
}

Header read_header(Words& words, const std::filesystem::path& path) {
  Header header;
  while (true) {
    std::string_view word = words.next();
    if (word.starts_with("\xEF\xBB\xBF")) word.remove_prefix(3);
    const std::optional<std::size_t> key = key_of(word);
    if (!key) {
      const char first = word.empty() ? '0' : word[0];
      const bool is_letter = (first | 32) >= 'a' && (first | 32) <= 'z';
      if (is_letter && !is_void_word(word)) {
        refuse(path, fmt::format("the header has the word \"{}\", which no ESRI grid has",
                                 std::string(word.substr(0, 40))));
      }
      words.put_back(word);
      return header;
    }
    header.values[*key] = header_number(words.next(), kKeys[*key], path);
  }
}

double required(const Header& header, const char* key, const std::filesystem::path& path) {
  const std::optional<double> value = header[key];
  if (!value) refuse(path, fmt::format("the header lacks {}", key));
  return *value;
}

std::uint64_t count_of(const Header& header, const char* key, const std::filesystem::path& path) {
  const double value = required(header, key, path);
  if (value < 1.0 || value > 1e9 || value != std::floor(value)) {
    refuse(path, fmt::format("the header has {} for {}; a count is expected", value, key));
  }
  return static_cast<std::uint64_t>(value);
}

/// Returns the coordinate of the first sample's centre along one axis.
double first_centre(const Header& header, const char* corner, const char* centre, double cell,
                    const std::filesystem::path& path) {
  if (const std::optional<double> value = header[centre]) return *value;
  return required(header, corner, path) + 0.5 * cell;
}

void set_place(RasterInfo& info, const Header& header, const SideFiles& beside,
               const OpenOptions& options) {
  const std::filesystem::path& path = info.path;
  const double dx = header["dx"] ? *header["dx"] : required(header, "cellsize", path);
  const double dy = header["dy"] ? *header["dy"] : header["cellsize"].value_or(dx);
  if (!(dx > 0.0 && dy > 0.0)) {
    refuse(path,
           fmt::format("the header has cells of {} x {}; sizes above 0 are expected", dx, dy));
  }
  Georeference place;
  place.per_column = dvec2(dx, 0.0);
  place.per_row = dvec2(0.0, -dy);
  place.origin =
      dvec2(first_centre(header, "xllcorner", "xllcenter", dx, path),
            first_centre(header, "yllcorner", "yllcenter", dy, path) + dy * (info.height - 1));
  place.crs = options.crs.empty() ? crs_of_prj(beside.prj, info.notes) : options.crs;
  info.georeference = place;
  say_if_without_crs(info);
}

// A band of rows has about this many samples.
constexpr std::uint64_t kBandSamples = std::uint64_t{1} << 21;

/// Reads all heights band by band, and keeps them or only where the bands begin.
std::unique_ptr<Raster> read_body(Words& words, RasterInfo info,
                                  std::shared_ptr<const ByteSource> bytes,
                                  const std::optional<double>& own_mark,
                                  std::uint64_t most_in_memory) {
  const double mark = own_mark.value_or(-9999.0);
  const auto width = static_cast<std::size_t>(info.width);
  const auto height = static_cast<std::size_t>(info.height);
  const bool is_kept = width * height <= most_in_memory;
  const std::size_t rows = std::clamp<std::size_t>(
      std::min<std::uint64_t>(kBandSamples, most_in_memory) / width, 1, height);
  AscBody body(info, mark);
  std::vector<float> heights((is_kept ? height : rows) * width);
  std::vector<std::uint64_t> begins;
  for (std::size_t row = 0; row < height; row += rows) {
    begins.push_back(words.place());
    const std::size_t first = row * width, count = std::min(rows, height - row) * width;
    body.read(words, first, count, heights.data() + (is_kept ? first : 0));
  }
  if (!words.next().empty()) {
    refuse(info.path, fmt::format("it has more heights than the {} x {} of its header", info.width,
                                  info.height));
  }
  info.sample_type = body.all_whole() ? "int32" : "float32";
  if (body.has_comma())
    info.notes.emplace_back("Commas in the heights were read as decimal marks.");
  if (!own_mark && body.has_mark()) {
    info.notes.emplace_back(
        "The header names no value for voids, and -9999 was taken, as ESRI's programs do.");
  }
  if (is_kept) return std::make_unique<MemoryRaster>(std::move(info), std::move(heights));
  return std::make_unique<AscRaster>(std::move(info), std::move(bytes), mark,
                                     static_cast<int>(rows), std::move(begins));
}

}  // namespace

const Format kAscFormat{"ESRI grid (.asc)", is_asc, open_asc};

std::unique_ptr<Raster> read_asc(std::shared_ptr<const ByteSource> bytes, const SideFiles& beside,
                                 const std::filesystem::path& path, const OpenOptions& options,
                                 std::uint64_t most_in_memory) {
  RasterInfo info;
  info.path = path;
  info.format = "ESRI grid (.asc)";
  Words words(*bytes);
  const Header header = read_header(words, path);
  const std::uint64_t width = count_of(header, "ncols", path);
  const std::uint64_t height = count_of(header, "nrows", path);
  require_size(path, width, height, true);
  // A height takes a digit and a space at least.
  if (width * height > bytes->size() / 2 + 1) {
    refuse(path, fmt::format("the header promises {} x {} heights, and the file has only {} bytes",
                             width, height, bytes->size()));
  }
  info.width = static_cast<int>(width);
  info.height = static_cast<int>(height);
  set_place(info, header, beside, options);
  set_unit(info, options, 1.0, "metre");
  return read_body(words, std::move(info), std::move(bytes),
                   options.nodata ? options.nodata : header["nodata_value"], most_in_memory);
}

}  // namespace aerostat::elevation
