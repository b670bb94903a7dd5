#include "elevation/open.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <span>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "elevation/asc.hpp"
#include "elevation/bil.hpp"
#include "elevation/bytes.hpp"
#include "elevation/dted.hpp"
#include "elevation/exr.hpp"
#include "elevation/format.hpp"
#include "elevation/gdal_program.hpp"
#include "elevation/geotiff.hpp"
#include "elevation/hgt.hpp"
#include "elevation/plausible.hpp"
#include "elevation/png.hpp"
#include "elevation/raw.hpp"
#include "elevation/usgs_dem.hpp"

namespace aerostat::elevation {
namespace {

/// The formats in the order in which they are tried. Those without a mark in their content come
/// last.
const std::array kFormats{&kGeoTiffFormat, &kAscFormat,          &kDtedFormat, &kUsgsDemFormat,
                          &kPngFormat,     &kLossyPictureFormat, &kExrFormat,  &kGdalFormat,
                          &kBilFormat,     &kRawFormat,          &kHgtFormat};

std::vector<std::uint8_t> head_of(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) {
    throw Error(ErrorKind::io,
                fmt::format("{}: cannot read heights: it is a directory", path.string()));
  }
  if (std::filesystem::exists(path, code) && !std::filesystem::is_regular_file(path, code)) {
    throw Error(ErrorKind::io,
                fmt::format("{}: cannot read heights: it is not a regular file", path.string()));
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw Error(ErrorKind::io, fmt::format("{}: cannot read heights: {}", path.string(),
                                           std::strerror(errno != 0 ? errno : EIO)));
  }
  std::vector<std::uint8_t> head(4096);
  file.read(reinterpret_cast<char*>(head.data()), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

}  // namespace

bool is_elevation(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) return true;
  try {
    const std::vector<std::uint8_t> head = head_of(path);
    return std::any_of(kFormats.begin(), kFormats.end(),
                       [&](const Format* format) { return format->matches(head, path); });
  } catch (const Error&) {
    return false;
  }
}

std::unique_ptr<Raster> open(const std::filesystem::path& path, const OpenOptions& options) {
  const std::vector<std::uint8_t> head = head_of(path);
  for (const Format* format : kFormats) {
    if (!format->matches(head, path)) continue;
    std::unique_ptr<Raster> raster = format->open(path, options);
    require_plausible_place(raster->info(), !options.crs.empty());
    return raster;
  }
  throw Error(ErrorKind::bad_data,
              fmt::format("{}: this is no file of heights of a known format", path.string()));
}

}  // namespace aerostat::elevation
