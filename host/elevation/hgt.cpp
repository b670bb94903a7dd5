#include "elevation/hgt.hpp"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "elevation/reading.hpp"
#include "elevation/sample_raster.hpp"
#include "elevation/zip.hpp"

namespace aerostat::elevation {
namespace {

constexpr std::array<std::array<int, 2>, 4> kSizes{
    {{1201, 1201}, {3601, 3601}, {1801, 3601}, {7201, 7201}}};
constexpr std::uint64_t kMostBytes = 2 * 7201 * 7201;

bool is_zip(std::span<const std::uint8_t> head) {
  return head.size() >= 4 && head[0] == 'P' && head[1] == 'K' &&
         ((head[2] == 3 && head[3] == 4) || (head[2] == 5 && head[3] == 6));
}

bool is_gzip(std::span<const std::uint8_t> head) {
  return head.size() >= 2 && head[0] == 0x1f && head[1] == 0x8b;
}

bool is_hgt(std::span<const std::uint8_t> head, const std::filesystem::path& path) {
  return is_zip(head) || (is_gzip(head) && ending_of(path.stem()) == ".hgt") ||
         ending_of(path) == ".hgt";
}

std::unique_ptr<Raster> open_hgt(const std::filesystem::path& path, const OpenOptions& options) {
  const auto bytes = file_bytes(path);
  std::vector<std::uint8_t> head(4);
  if (bytes->size() >= head.size()) bytes->read(0, 0, 1, head);
  if (is_zip(head) || is_gzip(head)) {
    return read_packed_hgt(read_whole(path, 2 * kMostBytes), path, options);
  }
  return read_hgt(bytes, path.filename().string(), path, options);
}

/// Returns a whole number that begins at `at` with `digits` digits, or a negative number.
int digits_at(const std::string& text, std::size_t at, std::size_t digits) {
  if (at + digits > text.size()) return -1;
  int value = 0;
  for (std::size_t i = at; i < at + digits; ++i) {
    if (text[i] < '0' || text[i] > '9') return -1;
    value = 10 * value + (text[i] - '0');
  }
  return value;
}

bool is_letter_or_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

void set_size(RasterInfo& info, std::uint64_t bytes) {
  for (const auto& [width, height] : kSizes) {
    if (bytes != std::uint64_t{2} * width * height) continue;
    info.width = width;
    info.height = height;
    return;
  }
  refuse(info.path,
         fmt::format("a .hgt file of {} bytes was found; {} (1201 x 1201 samples), {} (3601 x "
                     "3601), {} (1801 x 3601) or {} (7201 x 7201) are expected",
                     bytes, 2 * 1201 * 1201, 2 * 3601 * 3601, 2 * 1801 * 3601, 2 * 7201 * 7201));
}

void set_place(RasterInfo& info, const std::string& name, const OpenOptions& options) {
  const auto corner = corner_of_name(name);
  if (corner) {
    Georeference place;
    place.crs = options.crs.empty() ? "EPSG:4326" : options.crs;
    place.origin = dvec2((*corner)[1], (*corner)[0] + 1.0);
    place.per_column = dvec2(1.0 / (info.width - 1), 0.0);
    place.per_row = dvec2(0.0, -1.0 / (info.height - 1));
    info.georeference = place;
    return;
  }
  if (!options.cell_m) {
    refuse(info.path, fmt::format("the name {} does not give the place of the tile; a name such as "
                                  "N46E009.hgt does, and /terrain/cell_m uses it without a place",
                                  name));
  }
  info.georeference = place_without_earth(info, options);
  info.notes.push_back(fmt::format(
      "The name {} does not give the place of the tile, and the distance of its samples is taken "
      "from /terrain/cell_m.",
      name));
}

}  // namespace

const Format kHgtFormat{"SRTM tile (.hgt)", is_hgt, open_hgt};

std::optional<std::array<double, 2>> corner_of_name(const std::string& name) {
  const std::string lower = lower_case(name);
  for (std::size_t i = 0; i + 7 <= lower.size(); ++i) {
    if (i > 0 && is_letter_or_digit(lower[i - 1])) continue;
    if (i + 7 < lower.size() && lower[i + 7] >= '0' && lower[i + 7] <= '9') continue;
    const char ns = lower[i], ew = lower[i + 3];
    const int latitude = digits_at(lower, i + 1, 2), longitude = digits_at(lower, i + 4, 3);
    if ((ns != 'n' && ns != 's') || (ew != 'e' && ew != 'w')) continue;
    if (latitude < 0 || latitude > 90 || longitude < 0 || longitude > 180) continue;
    const double latitude_deg = latitude, longitude_deg = longitude;
    return std::array<double, 2>{ns == 'n' ? +latitude_deg : -latitude_deg,
                                 ew == 'e' ? +longitude_deg : -longitude_deg};
  }
  return std::nullopt;
}

std::unique_ptr<Raster> read_hgt(std::shared_ptr<const ByteSource> bytes, const std::string& name,
                                 const std::filesystem::path& path, const OpenOptions& options) {
  RasterInfo info;
  info.path = path;
  info.format = "SRTM tile (.hgt)";
  info.sample_type = "int16";
  info.vertical_datum = "EGM96 height";
  set_size(info, bytes->size());
  set_place(info, name, options);
  set_unit(info, options, 1.0, "metre");
  SampleLayout layout;
  layout.type = SampleType::int16;
  layout.big_endian = true;
  layout.row_stride = std::uint64_t{2} * info.width;
  layout.voids = {-32768.0};
  if (options.nodata) layout.voids.push_back(*options.nodata);
  layout.scale = info.metres_per_unit;
  return std::make_unique<SampleRaster>(std::move(info), std::move(bytes), std::move(layout));
}

std::unique_ptr<Raster> read_packed_hgt(std::span<const std::uint8_t> bytes,
                                        const std::filesystem::path& path,
                                        const OpenOptions& options) {
  if (is_gzip(bytes)) {
    return read_hgt(memory_bytes(unpack_gzip(bytes, path, kMostBytes)), path.filename().string(),
                    path, options);
  }
  ZipMember member = unpack_zip(bytes, path, ".hgt", kMostBytes);
  const std::string outside = path.filename().string();
  const bool is_named = corner_of_name(member.name).has_value();
  return read_hgt(memory_bytes(std::move(member.bytes)), is_named ? member.name : outside, path,
                  options);
}

}  // namespace aerostat::elevation
