#include "map/own_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "land/grid_place.hpp"
#include "map/land_place.hpp"
#include "scene/scene.hpp"
#include "terrain/real_land.hpp"

namespace aerostat::map {
namespace {

using land::LandPoint;

/// Points along a side of the lattice by which the part of a grid is found.
constexpr int kLattice = 65;
constexpr int kRows = 64;  // that a task resamples, at least

dvec2 as_local(const dvec2& east_north) {
  return {east_north.x, -east_north.y};
}

/// A range of samples along columns or rows.
struct Range {
  int first = 0, count = 0;
};

Range range_of(double least, double most, int samples) {
  const double first = std::clamp(std::floor(least), 0.0, samples - 1.0);
  const double last = std::clamp(std::ceil(most), 0.0, samples - 1.0);
  if (!(least <= samples - 1.0) || !(most >= 0.0)) return {};
  return {static_cast<int>(first), static_cast<int>(last - first) + 1};
}

/// Returns the weight of cubic convolution at a distance in samples.
double cubic(double distance) {
  const double x = std::abs(distance);
  if (x >= 2.0) return 0.0;
  if (x >= 1.0) return ((-0.5 * x + 2.5) * x - 4.0) * x + 2.0;
  return (1.5 * x - 2.5) * x * x + 1.0;
}

/// The pixels along one direction that a sample is made of, and their weights.
struct Taps {
  int first = 0;
  std::vector<double> weights;

  /// `reach` is the distance of samples in pixels, at least 1.
  void set(double at, double reach, int pixels) {
    first = std::max(static_cast<int>(std::floor(at - 2.0 * reach)) + 1, 0);
    const int last = std::min(static_cast<int>(std::floor(at + 2.0 * reach)), pixels - 1);
    weights.clear();
    double sum = 0.0;
    for (int i = first; i <= last; ++i) {
      weights.push_back(cubic((i - at) / reach));
      sum += weights.back();
    }
    for (double& weight : weights) weight /= sum;
  }
};

class Resampler {
 public:
  Resampler(const image::Pixels& picture, const MapView& view, const OwnGrid& grid,
            const elevation::Raster& raster, const dvec2& first, MapPixels& map)
      : picture_(picture), view_(view), grid_(grid), raster_(raster), first_(first), map_(map) {
    std::array<dvec2, 3> places{dvec2(0.5 * grid.width, 0.5 * grid.height)};
    places[1] = places[0] + dvec2(1.0, 0.0);
    places[2] = places[0] + dvec2(0.0, 1.0);
    to_pixels(places);
    const dvec2 column = glm::abs(places[1] - places[0]), row = glm::abs(places[2] - places[0]);
    reach_ = glm::max(glm::max(column, row), dvec2(1.0));
  }

  void fill_rows(int begin, int end) const {
    const auto width = static_cast<std::size_t>(grid_.width);
    std::vector<float> heights(width);
    // All rows at once, because opening the coordinate systems takes longer than a row.
    std::vector<dvec2> all;
    for (int row = begin; row < end; ++row) {
      for (int i = 0; i < grid_.width; ++i) all.emplace_back(i, row);
    }
    to_pixels(all);
    Taps across, down;
    for (int row = begin; row < end; ++row) {
      const dvec2* const places = &all[static_cast<std::size_t>(row - begin) * width];
      raster_.read({static_cast<int>(first_.x), static_cast<int>(first_.y) + row, grid_.width, 1},
                   heights.data());
      for (std::size_t i = 0; i < width; ++i) {
        if (std::isnan(heights[i]) || !shows(places[i])) continue;
        across.set(places[i].x, reach_.x, picture_.width);
        down.set(places[i].y, reach_.y, picture_.height);
        mix(across, down, &map_.rgba[4 * (static_cast<std::size_t>(row) * width + i)]);
      }
    }
  }

 private:
  void to_pixels(std::span<dvec2> places) const {
    land::grid_to_local(grid_.georeference, grid_.middle, places);
    for (dvec2& place : places) place = view_.pixel_at(as_local(place));
  }

  bool shows(const dvec2& pixel) const {
    return pixel.x >= -0.5 && pixel.y >= -0.5 && pixel.x <= picture_.width - 0.5 &&
           pixel.y <= picture_.height - 0.5;
  }

  void mix(const Taps& across, const Taps& down, std::uint8_t* rgba) const {
    dvec3 sum(0.0);
    for (std::size_t j = 0; j < down.weights.size(); ++j) {
      const std::size_t row =
          (static_cast<std::size_t>(down.first) + j) * static_cast<std::size_t>(picture_.width);
      for (std::size_t i = 0; i < across.weights.size(); ++i) {
        const std::uint8_t* pixel =
            &picture_.rgb[3 * (row + static_cast<std::size_t>(across.first) + i)];
        sum += down.weights[j] * across.weights[i] * dvec3(pixel[0], pixel[1], pixel[2]);
      }
    }
    for (int k = 0; k < 3; ++k) {
      rgba[k] = static_cast<std::uint8_t>(std::lround(std::clamp(sum[k], 0.0, 255.0)));
    }
    rgba[3] = 255;
  }

  const image::Pixels& picture_;
  const MapView& view_;
  const OwnGrid& grid_;
  const elevation::Raster& raster_;
  dvec2 first_;
  MapPixels& map_;
  dvec2 reach_{1.0};
};

const elevation::Raster& first_raster(const land::Land& land) {
  return land.pyramids()[0]->raster();
}

}  // namespace

OwnGrid own_grid(const scene::ResolvedScene& scene, const MapView& view, int width, int height,
                 const char* option, world::ReliefCache& reliefs) {
  OwnGrid grid;
  grid.land = terrain::real_land(require_real_land(*scene, option), reliefs.lands);
  grid.middle = terrain::middle_point(scene->terrain, *grid.land);
  const elevation::RasterInfo& info = first_raster(*grid.land).info();
  std::vector<dvec2> points;
  for (int j = 0; j < kLattice; ++j) {
    for (int i = 0; i < kLattice; ++i) {
      const dvec2 pixel(-0.5 + width * i / (kLattice - 1.0), -0.5 + height * j / (kLattice - 1.0));
      points.push_back(as_local(view.corner + pixel.x * view.right + pixel.y * view.down));
    }
  }
  land::local_to_grid(*info.georeference, grid.middle, points);
  dvec2 least(std::numeric_limits<double>::infinity()), most(-least);
  for (const dvec2& point : points) {
    if (!std::isfinite(point.x + point.y)) continue;
    least = glm::min(least, point);
    most = glm::max(most, point);
  }
  const Range columns = range_of(least.x, most.x, info.width);
  const Range rows = range_of(least.y, most.y, info.height);
  if (columns.count == 0 || rows.count == 0) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: the picture shows nothing of {}", option, info.path.string()));
  }
  grid.width = columns.count;
  grid.height = rows.count;
  grid.georeference = *info.georeference;
  grid.georeference.origin += static_cast<double>(columns.first) * info.georeference->per_column +
                              static_cast<double>(rows.first) * info.georeference->per_row;
  return grid;
}

MapPixels in_own_grid(const image::Pixels& picture, const MapView& view, const OwnGrid& grid) {
  MapPixels map{grid.width, grid.height, {}};
  map.rgba.assign(4 * static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height),
                  0);
  const elevation::Raster& raster = first_raster(*grid.land);
  const elevation::Georeference& whole = *raster.info().georeference;
  const dvec2 first = glm::round(glm::inverse(glm::dmat2(whole.per_column, whole.per_row)) *
                                 (grid.georeference.origin - whole.origin));
  const Resampler resampler(picture, view, grid, raster, first, map);
  tbb::parallel_for(tbb::blocked_range<int>(0, grid.height, kRows),
                    [&](const auto& rows) { resampler.fill_rows(rows.begin(), rows.end()); });
  return map;
}

}  // namespace aerostat::map
