#include "pack/cloud_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <oneapi/tbb/parallel_for.h>

#include "pack/cloud_waves.hpp"
#include "rules/cumulus.h"
#include "terrain/noise.hpp"

namespace aerostat::pack {
namespace {

constexpr int kSide = AERO_CHART_SIDE;
constexpr float kCellsPerSize = 6.0f;
/// The chart moves with the eye by whole tiles.
constexpr int kTile = 32;

/// Of noise with unit gradients, per wavelength: what no second derivative exceeds (9.226).
constexpr float kNoiseBend = 9.24f;
constexpr auto kNoiseBound = static_cast<float>(terrain::kNoiseBound);
/// Beyond this share of a wavelength, value and slope say less of the noise than its bound does.
constexpr float kFarthestShare = 0.35f;
/// There is no cloud where the coverage noise exceeds its threshold by less.
constexpr float kLeastExcess = CUMULUS_SPREAD * CUMULUS_LEAST_EXCESS;
/// Single precision, on the host and on the device.
constexpr float kNumericalMargin = 2e-3f;

/// Squares whose middles are points; whether each may hold a cloud.
class Judge {
 public:
  Judge(const AeroCumulus& clouds, float side)
      : waves_(all_waves(clouds)),
        least_(clouds.threshold + kLeastExcess - kNumericalMargin),
        radius_(0.7072f * side) {}

  /// Footprints fade octaves out from the shortest on, and rags count for a share. In both cases
  /// the sum is between those of the longest octaves.
  void operator()(const terrain::Points& middles, std::array<bool, terrain::kBlockSize>& maybe) {
    sum_ = {};
    for (const CloudWave& wave : waves_) add(wave, middles);
    for (int i = 0; i < middles.count; ++i) maybe[i] = sum_.most[i] > least_;
  }

 private:
  struct Sum {
    terrain::Block value{}, dx{}, dz{};
    float bend = 0.0f, rest = 0.0f;
    terrain::Block most{};  // none of the octaves: 0
  };

  void add(const CloudWave& wave, const terrain::Points& middles) {
    const float a = wave.amplitude, length = wave.layer.wavelength_m;
    if (radius_ > kFarthestShare * length) {
      sum_.rest += a * kNoiseBound;
    } else {
      terrain::Block value, dx, dz;
      terrain::sample(wave.layer, middles, value, dx, dz);
      for (int i = 0; i < middles.count; ++i) {
        sum_.value[i] += a * value[i];
        sum_.dx[i] += a * dx[i];
        sum_.dz[i] += a * dz[i];
      }
      sum_.bend += a * kNoiseBend / (length * length);
    }
    for (int i = 0; i < middles.count; ++i) {
      const float slope = std::sqrt(sum_.dx[i] * sum_.dx[i] + sum_.dz[i] * sum_.dz[i]);
      const float reach = radius_ * (slope + 0.5f * radius_ * sum_.bend);
      sum_.most[i] = std::max(sum_.most[i], sum_.value[i] + reach + sum_.rest);
    }
  }

  std::vector<CloudWave> waves_;
  float least_, radius_;
  Sum sum_;
};

/// A square of cells or a part of one; x and z of its lower corner from the chart's.
struct Square {
  float x, z;
};

/// Those of the squares that may hold clouds.
std::vector<Square> cloudy_ones(const AeroCumulus& clouds, const AeroCloudChart& chart,
                                const std::vector<Square>& squares, float side) {
  Judge judge(clouds, side);
  std::vector<Square> left;
  terrain::Points middles{};
  std::array<bool, terrain::kBlockSize> maybe{};
  for (std::size_t first = 0; first < squares.size(); first += terrain::kBlockSize) {
    const auto count = std::min<std::size_t>(terrain::kBlockSize, squares.size() - first);
    middles.count = static_cast<int>(count);
    for (std::size_t i = 0; i < count; ++i) {
      middles.x[i] = chart.x0 + squares[first + i].x + 0.5f * side;
      middles.z[i] = chart.z0 + squares[first + i].z + 0.5f * side;
    }
    judge(middles, maybe);
    for (std::size_t i = 0; i < count; ++i) {
      if (maybe[i]) left.push_back(squares[first + i]);
    }
  }
  return left;
}

std::vector<Square> quarters(const std::vector<Square>& squares, float side) {
  std::vector<Square> parts;
  parts.reserve(4 * squares.size());
  for (const Square& s : squares) {
    const float x = s.x + 0.5f * side, z = s.z + 0.5f * side;
    for (const Square& part : {Square{s.x, s.z}, {x, s.z}, {s.x, z}, {x, z}}) parts.push_back(part);
  }
  return parts;
}

/// In cells from each cell to the next that may hold a cloud, across or along, whichever is more.
using Distances = std::vector<std::uint8_t>;

/// Marks the cells of a row of tiles that may hold clouds with 0.
void survey(const AeroCumulus& clouds, const AeroCloudChart& chart, int tile_z,
            Distances& distances) {
  float side = 2.0f * chart.cell;
  std::vector<Square> squares;
  for (int z = tile_z * kTile; z < (tile_z + 1) * kTile; z += 2) {
    for (int x = 0; x < kSide; x += 2) {
      squares.push_back({static_cast<float>(x) * chart.cell, static_cast<float>(z) * chart.cell});
    }
  }
  for (;;) {
    squares = cloudy_ones(clouds, chart, squares, side);
    if (side < 0.6f * chart.cell) break;
    squares = quarters(squares, side);
    side *= 0.5f;
  }
  for (const Square& s : squares) {
    const int x = static_cast<int>((s.x + 0.5f * side) / chart.cell);
    const int z = static_cast<int>((s.z + 0.5f * side) / chart.cell);
    distances[static_cast<std::size_t>(z * kSide + x)] = 0;
  }
}

/// One pass forth and one back; what lies beyond the chart may be cloudy.
void spread(Distances& distances) {
  const auto pass = [&](int from, int to, int step) {
    for (int z = from; z != to; z += step) {
      for (int x = from; x != to; x += step) {
        int least = distances[static_cast<std::size_t>(z * kSide + x)];
        const auto neighbour = [&](int nx, int nz) {
          const bool outside = nx < 0 || nz < 0 || nx >= kSide || nz >= kSide;
          const int there = outside ? 0 : distances[static_cast<std::size_t>(nz * kSide + nx)];
          least = std::min(least, there + 1);
        };
        neighbour(x - step, z);
        neighbour(x - step, z - step);
        neighbour(x, z - step);
        neighbour(x + step, z - step);
        distances[static_cast<std::size_t>(z * kSide + x)] = static_cast<std::uint8_t>(least);
      }
    }
  };
  pass(0, kSide, 1);
  pass(kSide - 1, -1, -1);
}

void mark_cells(const AeroCumulus& clouds, CloudChart& chart) {
  Distances distances(static_cast<std::size_t>(kSide) * kSide, 255);
  tbb::parallel_for(0, kSide / kTile,
                    [&](int tile_z) { survey(clouds, chart.place, tile_z, distances); });
  spread(distances);
  chart.words.resize(AERO_CHART_WORDS);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    chart.words[i / 4].cells |= std::uint32_t{distances[i]} << (8 * (i % 4));
  }
}

float corner_by(float eye, float tile) {
  return tile * (std::floor(eye / tile) - static_cast<float>(kSide / kTile / 2));
}

}  // namespace

std::shared_ptr<const CloudChart> cloud_chart(const AeroCumulus& clouds, const vec3& eye,
                                              CloudChartCache& cache) {
  const bool some_clear = clouds.threshold + kLeastExcess - kNumericalMargin > 0.0f;
  if (!(clouds.extinction > 0.0f) || !some_clear) return nullptr;
  const float cell = clouds.size / kCellsPerSize;
  const float tile = static_cast<float>(kTile) * cell;
  // The chart is made where the clouds were before the wind carried them, so that clouds that drift
  // need no new one until the eye has left its tile.
  const float x0 = corner_by(eye.x - clouds.drift[0], tile);
  const float z0 = corner_by(eye.z - clouds.drift[1], tile);
  return cache.get({clouds.size, clouds.threshold, clouds.seed, x0, z0}, [&] {
    const auto chart = std::make_shared<CloudChart>();
    chart->place = {x0, z0, cell, kSide};
    mark_cells(clouds, *chart);
    return chart;
  });
}

}  // namespace aerostat::pack
