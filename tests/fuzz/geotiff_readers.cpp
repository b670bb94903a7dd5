#include "geotiff_readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "elevation/geokeys.hpp"
#include "elevation/geotiff.hpp"
#include "fuzz_file.hpp"
#include "geo/transform.hpp"

namespace aerostat::test {
namespace {

void require_sentences(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) {
    if (note.empty() || note.back() != '.') complain("a note is no sentence: " + note);
  }
}

/// Reads the first and the last samples of the raster and of its overviews.
void read_some(const elevation::Raster& raster) {
  std::vector<float> heights(std::size_t{64} * 64);
  const auto read = [&](int level, int width, int height) {
    const elevation::Window first{0, 0, std::min(width, 64), std::min(height, 64)};
    elevation::Window last = first;
    last.column = width - last.width;
    last.row = height - last.height;
    for (const elevation::Window& window : {first, last}) {
      if (level < 0) {
        raster.read(window, heights.data());
      } else {
        raster.read_overview(level, window, heights.data());
      }
    }
  };
  read(-1, raster.info().width, raster.info().height);
  for (std::size_t i = 0; i < raster.overview_factors().size(); ++i) {
    const int level = static_cast<int>(i);
    const auto [width, height] = raster.overview_size(level);
    if (!(raster.overview_factors()[i] > 1.0)) complain("an overview is not coarser");
    read(level, width, height);
  }
}

}  // namespace

void read_geotiff(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(bytes);
  // An unknown system is refused in words that name the system instead of the file.
  std::unique_ptr<elevation::Raster> raster =
      elevation::open_geotiff_for(file.path(), {kPath, "GeoTIFF", false, {}}, {});
  const elevation::RasterInfo& info = raster->info();
  require_sentences(info.notes);
  if (info.georeference) {
    if (!std::isfinite(info.georeference->origin.x)) complain("the place is not finite");
    if (!info.georeference->crs.empty()) geo::crs_info(info.georeference->crs);
  }
  read_some(*raster);
}

void read_crs(std::span<const std::uint8_t> bytes) {
  naming_the_file([bytes] {
    const std::string text(bytes.begin(), bytes.end());
    const geo::CrsInfo info = geo::crs_info(text);
    if (!(info.metres_per_unit > 0.0)) complain("the unit makes no sense");
    const geo::Transform transform(text, {46.8, 9.9});
    std::array<dvec2, 3> points{dvec2(0.0), dvec2(1000.0, 2000.0), dvec2(-60000.0, 1e9)};
    transform.from_local(points);
    transform.to_local(points);
    for (const dvec2& point : points) {
      if (std::isinf(point.x) || std::isinf(point.y)) complain("a point is infinite");
    }
    geo::place_of(text, {1000.0, 40.0});
  });
}

void read_geokeys(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 2) return;
  std::vector<std::uint16_t> shorts(bytes[0]);
  std::vector<double> doubles(bytes[1]);
  bytes = bytes.subspan(2);
  const auto take = [&bytes](void* to, std::size_t size) {
    size = std::min(size, bytes.size());
    if (size > 0) std::memcpy(to, bytes.data(), size);
    bytes = bytes.subspan(size);
  };
  take(shorts.data(), shorts.size() * sizeof(std::uint16_t));
  take(doubles.data(), doubles.size() * sizeof(double));
  const std::string texts(bytes.begin(), bytes.end());
  const elevation::GeoKeyCrs crs = elevation::crs_of(elevation::GeoKeys(shorts, doubles, texts));
  require_sentences(crs.notes);
  if (!crs.crs.empty()) geo::crs_info(crs.crs);
  if (!std::isfinite(crs.metres_per_unit)) complain("the unit makes no sense");
}

}  // namespace aerostat::test
