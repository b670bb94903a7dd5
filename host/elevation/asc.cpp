#include "elevation/asc.hpp"

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
  return read_asc(*file_bytes(path), side_files_of(path), path, options);
}

/// Returns whether a word stands for a missing height.
bool is_void_word(std::string_view word) {
  const std::string lower = lower_case(word);
  for (const char* known : {"nan", "-nan", "+nan", "null", "nodata", "na", "n/a", "inf", "-inf",
                            "1.#qnan", "-1.#qnan", "1.#ind", "-1.#ind", "1.#inf", "-1.#inf"}) {
    if (lower == known) return true;
  }
  return false;
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

/// The heights of a file and what was seen while they were read.
struct Body {
  std::vector<float> heights;
  bool all_whole = true, has_comma = false, has_mark = false;
};

[[noreturn]] void refuse_value(const RasterInfo& info, std::size_t index, std::string_view word) {
  const auto width = static_cast<std::size_t>(info.width);
  if (word.empty()) {
    refuse(info.path, fmt::format("it has {} heights, and the header promises {} x {}; the file "
                                  "is cut short",
                                  index, info.width, info.height));
  }
  refuse(info.path,
         fmt::format("row {}, column {} has \"{}\"; a height is expected", index / width + 1,
                     index % width + 1, std::string(word.substr(0, 40))));
}

Body read_body(Words& words, const RasterInfo& info, double mark) {
  constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();
  Body body;
  const std::size_t count =
      static_cast<std::size_t>(info.width) * static_cast<std::size_t>(info.height);
  body.heights.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view word = words.next();
    double value = plain_number(word);
    if (std::isnan(value) && !is_void_word(word)) {
      const std::optional<double> number = number_of(word);
      if (!number) refuse_value(info, i, word);
      value = *number;
    }
    if (is_no_height(value) || is_mark(value, mark)) {
      body.has_mark |= value == mark;
      body.heights.push_back(kVoid);
      continue;
    }
    body.all_whole &= value == std::floor(value);
    body.has_comma |= word.find(',') != std::string_view::npos;
    body.heights.push_back(static_cast<float>(value * info.metres_per_unit));
  }
  if (!words.next().empty()) {
    refuse(info.path, fmt::format("it has more heights than the {} x {} of its header", info.width,
                                  info.height));
  }
  return body;
}

}  // namespace

const Format kAscFormat{"ESRI grid (.asc)", is_asc, open_asc};

std::unique_ptr<Raster> read_asc(const ByteSource& bytes, const SideFiles& beside,
                                 const std::filesystem::path& path, const OpenOptions& options) {
  RasterInfo info;
  info.path = path;
  info.format = "ESRI grid (.asc)";
  Words words(bytes);
  const Header header = read_header(words, path);
  const std::uint64_t width = count_of(header, "ncols", path);
  const std::uint64_t height = count_of(header, "nrows", path);
  require_size(path, width, height, false);
  // A height takes a digit and a space at least.
  if (width * height > bytes.size() / 2 + 1) {
    refuse(path, fmt::format("the header promises {} x {} heights, and the file has only {} bytes",
                             width, height, bytes.size()));
  }
  info.width = static_cast<int>(width);
  info.height = static_cast<int>(height);
  set_place(info, header, beside, options);
  set_unit(info, options, 1.0, "metre");
  const std::optional<double> own_mark = options.nodata ? options.nodata : header["nodata_value"];
  Body body = read_body(words, info, own_mark.value_or(-9999.0));
  info.sample_type = body.all_whole ? "int32" : "float32";
  if (body.has_comma) info.notes.push_back("Commas in the heights were read as decimal marks.");
  if (!own_mark && body.has_mark) {
    info.notes.push_back(
        "The header names no value for voids, and -9999 was taken, as ESRI's programs do.");
  }
  return std::make_unique<MemoryRaster>(std::move(info), std::move(body.heights));
}

}  // namespace aerostat::elevation
