#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "land/grid_place.hpp"
#include "land/land.hpp"

namespace aerostat::land {
namespace {

constexpr int kFewestNodes = 33, kMostNodes = 1025;  // along a side of a lattice
/// By how much of a sample a lattice may be off between its nodes.
constexpr double kLatticeError = 0.02;
/// Over so many samples from the rim of a raster, it gives way to the next one.
constexpr double kFeather = 8.0;

}  // namespace

/// A raster, and where points of the local frame lie in it. Between the nodes of a square lattice,
/// places are interpolated, which is exact to a small part of a sample.
class LocalLand::Lattice {
 public:
  Lattice(const Pyramid& pyramid, const LandPoint& middle, double reach_m)
      : pyramid_(pyramid), reach_m_(reach_m) {
    const elevation::Georeference& grid = *pyramid.raster().info().georeference;
    for (nodes_ = kFewestNodes;; nodes_ = 2 * nodes_ - 1) {
      places_.clear();
      for (int j = 0; j < nodes_; ++j)
        for (int i = 0; i < nodes_; ++i) places_.push_back({along(i), along(j)});
      local_to_grid(grid, middle, places_);
      hold_all();
      if (nodes_ >= kMostNodes || error(grid, middle) <= kLatticeError) break;
    }
    if (pyramid.water() != nullptr) find_cells_near_water();
  }

  /// A place in the raster, and how it changes by metres to the east and to the south.
  struct Seen {
    dvec2 place, by_east, by_south;
  };

  Seen at(double east_m, double south_m) const {
    const double step = 2.0 * reach_m_ / (nodes_ - 1);
    const double u = (east_m + reach_m_) / step, v = (south_m + reach_m_) / step;
    const int i = std::clamp(static_cast<int>(u), 0, nodes_ - 2);
    const int j = std::clamp(static_cast<int>(v), 0, nodes_ - 2);
    const double s = u - i, t = v - j;  // beyond the lattice, its outermost cells go on
    const dvec2 a = node(i, j), b = node(i + 1, j), c = node(i, j + 1), d = node(i + 1, j + 1);
    const dvec2 top = a + s * (b - a), bottom = c + s * (d - c);
    return {top + t * (bottom - top), ((b - a) + t * ((d - c) - (b - a))) / step,
            (bottom - top) / step};
  }

  /// Returns how much a raster counts at a place: 1 inside of it, falling to 0 at its rim.
  double share(const dvec2& place) const {
    const elevation::RasterInfo& info = pyramid_.raster().info();
    const double inside = std::min(
        {place.x + 0.5, info.width - 0.5 - place.x, place.y + 0.5, info.height - 0.5 - place.y});
    if (inside <= 0.0 || !pyramid_.is_known(place.x, place.y)) return 0.0;
    return std::min(inside / kFeather, 1.0);
  }

  /// Returns how far outside of the raster a place is, in samples.
  double distance(const dvec2& place) const {
    const elevation::RasterInfo& info = pyramid_.raster().info();
    const double x = std::max({-place.x, place.x - (info.width - 1), 0.0});
    const double y = std::max({-place.y, place.y - (info.height - 1), 0.0});
    return std::hypot(x, y);
  }

  /// Returns the metres of a number of samples around a place.
  float metres(const Seen& seen, double samples) const {
    return static_cast<float>(samples / std::sqrt(std::max(samples_per_area(seen), 1e-18)));
  }

  /// The height and the slopes to the east and to the south.
  struct Ground {
    float height, east, south;
  };

  Ground ground(const Seen& seen, double spacing_m) const {
    const double area = samples_per_area(seen);
    const SplinePoint point =
        pyramid_.at(seen.place.x, seen.place.y, spacing_m * std::sqrt(std::max(area, 1e-18)));
    const double columns = point.along_columns, rows = point.along_rows;
    return {point.height, static_cast<float>(columns * seen.by_east.x + rows * seen.by_east.y),
            static_cast<float>(columns * seen.by_south.x + rows * seen.by_south.y)};
  }

  /// Returns whether water of the raster may be near a point of the local frame.
  bool is_near_water(double east_m, double south_m) const {
    if (near_water_.empty()) return false;
    const double step = 2.0 * reach_m_ / (nodes_ - 1);
    const double u = (east_m + reach_m_) / step, v = (south_m + reach_m_) / step;
    const double last = nodes_ - 1.0;
    if (!(u >= 0.0 && u < last && v >= 0.0 && v < last)) return true;  // not looked at
    return near_water_[static_cast<std::size_t>(v) * static_cast<std::size_t>(nodes_ - 1) +
                       static_cast<std::size_t>(u)] != 0;
  }

  /// Returns the water of the raster, which must have some.
  WaterPoint water(const Seen& seen, double spacing_m) const {
    const double scale = std::sqrt(std::max(samples_per_area(seen), 1e-18));
    return pyramid_.water()->at(seen.place.x, seen.place.y, spacing_m * scale);
  }

  const Pyramid& pyramid() const { return pyramid_; }

 private:
  /// Returns the number of samples in a square metre.
  static double samples_per_area(const Seen& seen) {
    return std::abs(seen.by_east.x * seen.by_south.y - seen.by_east.y * seen.by_south.x);
  }

  double along(int node) const { return reach_m_ * (2.0 * node / (nodes_ - 1) - 1.0); }

  const dvec2& node(int i, int j) const {
    return places_[static_cast<std::size_t>(j) * static_cast<std::size_t>(nodes_) +
                   static_cast<std::size_t>(i)];
  }

  void find_cells_near_water() {
    for (int j = 0; j + 1 < nodes_; ++j)
      for (int i = 0; i + 1 < nodes_; ++i) {
        const dvec2 a = node(i, j), b = node(i + 1, j), c = node(i, j + 1), d = node(i + 1, j + 1);
        const bool near = pyramid_.water()->is_near(glm::min(glm::min(a, b), glm::min(c, d)),
                                                    glm::max(glm::max(a, b), glm::max(c, d)));
        near_water_.push_back(near ? 1 : 0);
      }
  }

  /// Puts nodes that have no place in the raster far outside of it.
  void hold_all() {
    for (dvec2& place : places_) {
      if (!std::isfinite(place.x) || !std::isfinite(place.y)) place = dvec2(-1e7);
      place = glm::clamp(place, dvec2(-1e7), dvec2(1e8));
    }
  }

  /// Returns by how many samples the lattice is off in the middle of some of its cells.
  double error(const elevation::Georeference& grid, const LandPoint& middle) const {
    std::vector<dvec2> exact, near;
    const double half = reach_m_ / (nodes_ - 1);
    for (int j = 0; j < nodes_ - 1; j += 4)
      for (int i = 0; i < nodes_ - 1; i += 4) {
        const dvec2 point(along(i) + half, along(j) + half);
        exact.push_back(point);
        near.push_back(at(point.x, point.y).place);
      }
    local_to_grid(grid, middle, exact);
    double worst = 0.0;
    for (std::size_t k = 0; k < exact.size(); ++k) {
      if (distance(near[k]) > 0.0 || !std::isfinite(exact[k].x + exact[k].y)) continue;
      worst = std::max(worst, glm::length(exact[k] - near[k]));
    }
    return worst;
  }

  const Pyramid& pyramid_;
  double reach_m_;
  int nodes_ = 0;
  std::vector<dvec2> places_;             // columns and rows, row by row
  std::vector<std::uint8_t> near_water_;  // cells between nodes; empty if there is no water
};

LocalLand::LocalLand(const Land& land, const LandPoint& point, double reach_m) {
  for (const auto& pyramid : land.pyramids()) {
    lattices_.push_back(std::make_unique<Lattice>(*pyramid, point, reach_m));
  }
}

LocalLand::~LocalLand() = default;

void LocalLand::sample(const LandSamples& samples) const {
  for (std::size_t k = 0; k < samples.east_m.size(); ++k) {
    double left = 1.0, nearest = std::numeric_limits<double>::infinity();
    Lattice::Ground sum{0.0f, 0.0f, 0.0f};
    const auto add = [&](const Lattice& lattice, const Lattice::Seen& seen, double share) {
      const Lattice::Ground ground = lattice.ground(seen, samples.spacing_m[k]);
      const auto weight = static_cast<float>(share);
      sum.height += weight * ground.height;
      sum.east += weight * ground.east;
      sum.south += weight * ground.south;
    };
    const Lattice* fallback = nullptr;
    Lattice::Seen fallback_seen{};
    for (const auto& lattice : lattices_) {
      const Lattice::Seen seen = lattice->at(samples.east_m[k], samples.south_m[k]);
      const double distance = lattice->distance(seen.place);
      if (distance < nearest) {
        nearest = distance;
        fallback = lattice.get();
        fallback_seen = seen;
      }
      if (lattices_.size() == 1) break;
      const double share = left * lattice->share(seen.place);
      if (!(share > 0.0)) continue;
      add(*lattice, seen, share);
      left -= share;
      if (left < 1e-3) break;
    }
    // Beyond all rasters, and at the rims of the last one, the nearest one goes on.
    if (left >= 1e-3) add(*fallback, fallback_seen, left);
    samples.height_m[k] = sum.height;
    samples.slope_east[k] = sum.east;
    samples.slope_south[k] = sum.south;
    if (samples.outside_m.empty()) continue;
    // All of the land is outside if no file has a share of it.
    const bool outside = left >= 1.0 && nearest > 0.0;
    samples.outside_m[k] = outside ? fallback->metres(fallback_seen, nearest) : 0.0f;
  }
}

bool LocalLand::has_water() const {
  return std::any_of(lattices_.begin(), lattices_.end(),
                     [](const auto& lattice) { return lattice->pyramid().water() != nullptr; });
}

void LocalLand::find_water(const WaterSamples& samples) const {
  for (std::size_t k = 0; k < samples.east_m.size(); ++k) {
    samples.level_m[k] = std::numeric_limits<float>::quiet_NaN();
    samples.shore_m[k] = -std::numeric_limits<float>::infinity();
    const double east_m = samples.east_m[k], south_m = samples.south_m[k];
    const bool near = std::any_of(lattices_.begin(), lattices_.end(), [&](const auto& lattice) {
      return lattice->is_near_water(east_m, south_m);
    });
    if (!near) continue;
    // The first raster that has a height at the place counts.
    for (const auto& lattice : lattices_) {
      const Lattice::Seen seen = lattice->at(east_m, south_m);
      if (!(lattice->share(seen.place) > 0.0)) continue;
      if (lattice->pyramid().water() == nullptr) break;
      const WaterPoint water = lattice->water(seen, samples.spacing_m[k]);
      samples.level_m[k] = water.level_m;
      samples.shore_m[k] = lattice->metres(seen, water.shore);
      break;
    }
  }
}

bool LocalLand::is_known(double east_m, double south_m) const {
  return std::any_of(lattices_.begin(), lattices_.end(), [&](const auto& lattice) {
    const dvec2 place = lattice->at(east_m, south_m).place;
    return lattice->pyramid().is_known(place.x, place.y);
  });
}

}  // namespace aerostat::land
