#include "pack/cloud_shadows.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "pack/cloud_waves.hpp"
#include "rules/cumulus.h"
#include "terrain/noise.hpp"

namespace aerostat::pack {
namespace {

/// Cells of the map of clouds for the width of a cloud, and steps of a sun's ray through the layer.
constexpr float kCellsPerSize = 10.0f;
constexpr int kCloudSteps = 8;
/// The height over which the edges of clouds are blurred in place of their bulges, in heights of
/// the layer. Chosen by eye.
constexpr float kSoftEdge = 0.3f;

/// Returns the words of shares.
std::vector<std::uint32_t> words_of_shares(const ShadowNodes& nodes) {
  const auto bits = [&](std::size_t column, std::size_t row) {
    return static_cast<std::uint32_t>(nodes.at(column, row) * 255.0f + 0.5f);
  };
  return make_words([&](std::size_t column, std::size_t row) {
    return bits(column, row) | bits(column + 1, row) << 8 | bits(column, row + 1) << 16 |
           bits(column + 1, row + 1) << 24;
  });
}

/// Sums of the waves of clouds at points.
struct CloudNoise {
  std::vector<CloudWave> waves;

  /// Adds them to `sum`, as far as cells of a map resolve them.
  void add(const terrain::Points& points, float cell, terrain::Block& sum) const {
    for (const CloudWave& wave : waves) {
      const float amplitude = wave.amplitude * rules::resolved(wave.layer.wavelength_m, cell);
      if (!(amplitude > 0.0f)) continue;
      terrain::Block value;
      terrain::sample(wave.layer, points, value);
      for (int i = 0; i < points.count; ++i) sum[i] += amplitude * value[i];
    }
  }
};

/// The excess of the clouds' coverage noise along rows of a map.
class CloudRows {
 public:
  CloudRows(const AeroCumulus& clouds, const SunAxes& axes, const AeroShadowMap& map)
      : clouds_(clouds),
        axes_(axes),
        map_(map),
        broad_{broad_waves(clouds)},
        rags_{rag_waves(clouds)} {}

  /// Fills in the excess at nodes of a row, of which there may be more than the map has.
  void operator()(std::size_t row, std::span<float> excess) const {
    const float v = map_.v + static_cast<float>(row) * map_.cell;
    for (std::size_t first = 0; first < excess.size(); first += terrain::kBlockSize) {
      terrain::Points points{};
      points.count =
          static_cast<int>(std::min<std::size_t>(terrain::kBlockSize, excess.size() - first));
      for (int i = 0; i < points.count; ++i) {
        const float u =
            map_.u + static_cast<float>(first + static_cast<std::size_t>(i)) * map_.cell;
        points.x[i] = axes_.x(u, v);
        points.z[i] = axes_.z(u, v);
      }
      terrain::Block broad{}, rags{};
      broad_.add(points, map_.cell, broad);
      rags_.add(points, map_.cell, rags);
      for (int i = 0; i < points.count; ++i) {
        const float over = (broad[i] - clouds_.threshold) / CUMULUS_SPREAD;
        excess[first + static_cast<std::size_t>(i)] =
            over + rags[i] / CUMULUS_SPREAD * rules::cumulus_ragged(over);
      }
    }
  }

 private:
  const AeroCumulus& clouds_;
  const SunAxes& axes_;
  const AeroShadowMap& map_;
  CloudNoise broad_, rags_;
};

/// Fills in `left`, the share of sunlight that clouds leave at each node of a row. `excess` is the
/// excess of the coverage noise over its threshold at the nodes of that row.
void shade_row(const AeroCumulus& clouds, const SunAxes& axes, float cell,
               std::span<const float> excess, std::span<float> left) {
  const float step = CUMULUS_TALLEST / kCloudSteps;
  const float sine = axes.rise / std::hypot(1.0f, axes.rise);
  const float depth_of_step = clouds.extinction * step * clouds.thickness / sine;
  for (std::size_t i = 0; i < left.size(); ++i) {
    float depth = 0.0f;
    for (int k = 0; k < kCloudSteps; ++k) {
      const float height = (static_cast<float>(k) + 0.5f) * step;
      const float at = static_cast<float>(i) + height * clouds.thickness / (axes.rise * cell);
      const auto column = std::min(static_cast<std::size_t>(at), excess.size() - 2);
      const float there =
          std::lerp(excess[column], excess[column + 1], at - static_cast<float>(column));
      depth += rules::cumulus_filled(there, 0.0f, height, kSoftEdge);
    }
    left[i] = rules::cumulus_transmittance(depth_of_step * depth);
  }
}

}  // namespace

AeroShadowMap place_of_clouds(const AeroCumulus& clouds, const vec3& eye, const SunAxes& axes) {
  const float cell = clouds.size / kCellsPerSize;
  const float x = eye.x - clouds.drift[0], z = eye.z - clouds.drift[1];
  const float towards = std::max(clouds.base - eye.y, 0.0f) / axes.rise;
  const float half = 0.5f * static_cast<float>(kShadowSide);
  return {cell * (std::round((axes.u(x, z) + towards) / cell) - half),
          cell * (std::round(axes.v(x, z) / cell) - half),
          cell,
          0.0f,
          0.0f,
          0};
}

ShadowMap cloud_shadows(const AeroCumulus& clouds, const vec3& eye, const vec3& sun) {
  const SunAxes axes(sun);
  ShadowMap map;
  map.place = place_of_clouds(clouds, eye, axes);
  const CloudRows rows(clouds, axes, map.place);
  const float reach = CUMULUS_TALLEST * clouds.thickness / (axes.rise * map.place.cell);
  const std::size_t columns = kShadowSide + static_cast<std::size_t>(reach) + 2;
  const ShadowNodes nodes = make_nodes([&](std::size_t row, std::span<float> values) {
    std::vector<float> excess(columns);
    rows(row, excess);
    shade_row(clouds, axes, map.place.cell, excess, values);
  });
  map.words = words_of_shares(nodes);
  const double sum = std::accumulate(nodes.values.begin(), nodes.values.end(), 0.0);
  map.mean = static_cast<float>(sum / static_cast<double>(nodes.values.size()));
  return map;
}

}  // namespace aerostat::pack
