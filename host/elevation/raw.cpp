#include "elevation/raw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "elevation/images.hpp"
#include "elevation/reading.hpp"
#include "elevation/sample_raster.hpp"

namespace aerostat::elevation {
namespace {

bool is_raw(std::span<const std::uint8_t>, const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  return ending == ".r16" || ending == ".r32" || ending == ".raw";
}

std::unique_ptr<Raster> open_raw(const std::filesystem::path& path, const OpenOptions& options) {
  return read_raw(file_bytes(path), side_files_of(path), path, options);
}

/// Returns the side of a square of `samples` samples, or 0.
std::uint64_t side_of(std::uint64_t samples) {
  auto side = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(samples)));
  while (side * side > samples) --side;
  while ((side + 1) * (side + 1) <= samples) ++side;
  return side * side == samples ? side : 0;
}

SampleType type_of(RasterInfo& info, const OpenOptions& options, std::uint64_t bytes) {
  const std::string& name = options.raw.sample_type;
  if (const auto type = sample_type_of(name)) return *type;
  if (!name.empty()) {
    refuse(info.path, fmt::format("the sample type \"{}\" is unknown; uint8, int16, uint16, int32, "
                                  "uint32, float32 or float64 is expected",
                                  name));
  }
  const std::string ending = ending_of(info.path);
  if (ending == ".r16") return SampleType::uint16;
  if (ending == ".r32") return SampleType::float32;
  std::uint64_t samples = static_cast<std::uint64_t>(std::max(options.raw.width, 0)) *
                          static_cast<std::uint64_t>(std::max(options.raw.height, 0));
  const auto fits = [&](std::uint64_t sample_bytes) {
    if (bytes % sample_bytes != 0) return false;
    return samples > 0 ? bytes == samples * sample_bytes : side_of(bytes / sample_bytes) > 0;
  };
  for (const SampleType type : {SampleType::uint16, SampleType::float32}) {
    if (!fits(static_cast<std::uint64_t>(bytes_of(type)))) continue;
    info.notes.push_back(fmt::format(
        "The file does not say the type of its samples, and {} was taken, which fits its size.",
        name_of(type)));
    return type;
  }
  refuse(info.path, fmt::format("the file has {} bytes of samples, which fit no type; "
                                "/terrain/raw names the type, the width and the height",
                                bytes));
}

void set_size(RasterInfo& info, const OpenOptions& options, std::uint64_t bytes,
              std::uint64_t sample_bytes) {
  const RawLayout& raw = options.raw;
  if (raw.width < 0 || raw.height < 0) {
    refuse(info.path, fmt::format("{} x {} samples make no raster", raw.width, raw.height));
  }
  auto width = static_cast<std::uint64_t>(raw.width);
  auto height = static_cast<std::uint64_t>(raw.height);
  const std::uint64_t samples = bytes / sample_bytes;
  if (width == 0 && height == 0) {
    width = height = bytes % sample_bytes == 0 ? side_of(samples) : 0;
    if (width == 0) {
      refuse(info.path,
             fmt::format("the file has {} bytes, or {:.2f} samples of {} bytes, which "
                         "are no square; /terrain/raw names the width and the height",
                         bytes, static_cast<double>(bytes) / static_cast<double>(sample_bytes),
                         sample_bytes));
    }
  }
  if (width == 0) width = samples / height;
  if (height == 0) height = samples / width;
  require_size(info.path, width, height, true);
  if (width * height * sample_bytes != bytes) {
    refuse(info.path,
           fmt::format("the file has {} bytes behind its header, and {} x {} samples of "
                       "{} bytes need {}",
                       bytes, width, height, sample_bytes, width * height * sample_bytes));
  }
  info.width = static_cast<int>(width);
  info.height = static_cast<int>(height);
}

/// Returns how unlike heights a few rows are: the sum of steps between neighbours, or for floats
/// the number of values that no heights have.
double strangeness(const RasterInfo& info, const std::shared_ptr<const ByteSource>& bytes,
                   SampleLayout layout, bool big_endian) {
  const bool is_float = layout.type == SampleType::float32 || layout.type == SampleType::float64;
  layout.big_endian = big_endian;
  layout.scale = 1.0;
  layout.offset_m = 0.0;
  const SampleRaster raster(info, bytes, layout);
  std::vector<float> row(static_cast<std::size_t>(std::min(info.width, 4096)));
  double sum = 0.0;
  for (int k = 0; k < 8; ++k) {
    raster.read({0, static_cast<int>(std::int64_t{info.height - 1} * k / 7),
                 static_cast<int>(row.size()), 1},
                row.data());
    for (std::size_t i = 1; i < row.size(); ++i) {
      const double size = std::abs(static_cast<double>(row[i]));
      const double step = std::abs(static_cast<double>(row[i]) - static_cast<double>(row[i - 1]));
      if (is_float) {
        sum += size == 0.0 || (size > 1e-6 && size < 1e6) ? 0.0 : 1.0;
      } else if (!std::isnan(step)) {
        sum += step;
      }
    }
  }
  return sum;
}

}  // namespace

const Format kRawFormat{"raw file", is_raw, open_raw};

std::unique_ptr<Raster> read_raw(std::shared_ptr<const ByteSource> bytes, const SideFiles& beside,
                                 const std::filesystem::path& path, const OpenOptions& options) {
  RasterInfo info;
  info.path = path;
  info.format = "raw file";
  const std::uint64_t header = options.raw.header_bytes;
  if (header >= bytes->size()) {
    refuse(path, fmt::format("the file has {} bytes, and {} of them were said to be its header",
                             bytes->size(), header));
  }
  SampleLayout layout;
  layout.type = type_of(info, options, bytes->size() - header);
  info.sample_type = name_of(layout.type);
  info.format = fmt::format("raw file of {}", info.sample_type);
  const auto sample_bytes = static_cast<std::uint64_t>(bytes_of(layout.type));
  set_size(info, options, bytes->size() - header, sample_bytes);
  layout.first = header;
  layout.big_endian = options.raw.big_endian;
  layout.row_stride = sample_bytes * static_cast<std::uint64_t>(info.width);
  if (options.nodata) layout.voids.push_back(*options.nodata);
  const bool is_signed = layout.type != SampleType::uint8 && layout.type != SampleType::uint16 &&
                         layout.type != SampleType::uint32;
  const bool is_float = layout.type == SampleType::float32 || layout.type == SampleType::float64;
  const double highest =
      is_float ? 1.0
               : std::exp2(8.0 * static_cast<double>(sample_bytes) - (is_signed ? 1.0 : 0.0)) - 1.0;
  const double lowest = is_signed && !is_float ? -highest - 1.0 : 0.0;
  const HeightScale scale = height_scale_of(info, options, lowest, highest, is_signed);
  layout.scale = scale.scale;
  layout.offset_m = scale.offset_m;
  set_image_place(info, options, beside);
  if (sample_bytes > 1 && strangeness(info, bytes, layout, !layout.big_endian) * 8.0 <
                              strangeness(info, bytes, layout, layout.big_endian)) {
    info.notes.push_back(
        fmt::format("The heights would be far smoother in the other order of bytes; /terrain/raw "
                    "says {}-endian "
                    "now.",
                    layout.big_endian ? "big" : "little"));
  }
  return std::make_unique<SampleRaster>(std::move(info), std::move(bytes), std::move(layout));
}

}  // namespace aerostat::elevation
