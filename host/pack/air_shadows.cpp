#include "pack/air_shadows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include <oneapi/tbb/parallel_for.h>

#include "pack/cloud_waves.hpp"
#include "pack/pack_scene.hpp"
#include "rules/cumulus.h"
#include "terrain/noise.hpp"

namespace aerostat::pack {
namespace {

constexpr std::size_t kSide = AERO_SHADOW_SIDE;
/// Heights over the plane beyond the ground, in metres.
constexpr float kNoGround = -1e5f;
/// Shadows beyond the ground are not followed below this height.
constexpr float kSunken = -2e4f;
/// A sun so high casts no shadows that could be seen in the air: the sine of its distance from the
/// point straight above.
constexpr float kLeastLevel = 1e-3f;
/// The sine of the elevation below which clouds cast no shadows into the air.
constexpr float kLowestCloudSun = 0.02f;
/// Cells of the map of clouds for the width of a cloud, and steps of a sun's ray through the layer.
constexpr float kCellsPerSize = 10.0f;
constexpr int kCloudSteps = 8;
/// The height over which the edges of clouds are blurred in place of their bulges, in heights of
/// the layer. Chosen by eye.
constexpr float kSoftEdge = 0.3f;
/// The most points of a step through the air that are looked at for shadows, and the metres of air
/// that another point is worth if their optical depth is 1. Chosen by eye.
constexpr std::uint32_t kMostPoints = 4;
constexpr float kClearWay = 1e4f;
/// Shadows of land begin over this share of a cell. Chosen by eye.
constexpr float kLandSoftness = 0.5f;

vec3 vec_of(const aero_float (&from)[3]) {
  return {from[0], from[1], from[2]};
}

/// The axes of the maps: the unit vector towards the sun over the plane, and how steeply the sun's
/// rays rise for each metre over the plane.
struct SunAxes {
  explicit SunAxes(const vec3& sun) : level(std::hypot(sun.x, sun.z)) {
    if (level > kLeastLevel) along = vec2(sun.x, sun.z) / level;
    rise = sun.y / std::max(level, kLeastLevel);
  }

  float u(float x, float z) const { return along.x * x + along.y * z; }
  float v(float x, float z) const { return along.x * z - along.y * x; }
  float x(float u, float v) const { return along.x * u - along.y * v; }
  float z(float u, float v) const { return along.y * u + along.x * v; }

  float level;
  vec2 along{1.0f, 0.0f};
  float rise = 0.0f;
};

/// The lines of one axis of a grid, and where between them a coordinate lies.
class Lines {
 public:
  Lines(std::uint32_t count, auto line) : at_(count) {
    for (std::uint32_t i = 0; i < count; ++i) at_[i] = line(i);
  }

  float first() const { return at_.front(); }
  float last() const { return at_.back(); }
  bool has(float at) const { return at >= first() && at <= last(); }

  /// Returns the cell of a coordinate between the lines, and the share of it that lies before.
  std::pair<std::uint32_t, float> cell_of(float at) const {
    const auto next = std::upper_bound(at_.begin() + 1, at_.end() - 1, at);
    const float from = *(next - 1);
    return {static_cast<std::uint32_t>(next - at_.begin()) - 1, (at - from) / (*next - from)};
  }

 private:
  std::vector<float> at_;
};

/// The heights of a ground between its nodes.
class Heights {
 public:
  explicit Heights(const mesh::GridMesh& ground)
      : ground_(ground),
        x_(ground.columns() + 1, [&](std::uint32_t i) { return ground.x(i); }),
        z_(ground.rows() + 1, [&](std::uint32_t j) { return ground.z(j); }) {}

  const Lines& x() const { return x_; }
  const Lines& z() const { return z_; }

  float operator()(float x, float z) const {
    if (!x_.has(x) || !z_.has(z)) return kNoGround;
    const auto [i, s] = x_.cell_of(x);
    const auto [j, t] = z_.cell_of(z);
    const float near = std::lerp(ground_.height(i, j), ground_.height(i + 1, j), s);
    const float far = std::lerp(ground_.height(i, j + 1), ground_.height(i + 1, j + 1), s);
    return std::lerp(near, far, t);
  }

 private:
  const mesh::GridMesh& ground_;
  Lines x_, z_;
};

/// Returns the place of the map that covers the ground.
AeroShadowMap place_over(const Heights& heights, const vec3& place, const SunAxes& axes) {
  vec2 least(std::numeric_limits<float>::max()), most(std::numeric_limits<float>::lowest());
  for (const float x : {heights.x().first(), heights.x().last()}) {
    for (const float z : {heights.z().first(), heights.z().last()}) {
      const vec2 at(axes.u(x + place.x, z + place.z), axes.v(x + place.x, z + place.z));
      least = glm::min(least, at);
      most = glm::max(most, at);
    }
  }
  const float side = std::max(most.x - least.x, most.y - least.y);
  return {least.x, least.y, side / static_cast<float>(kSide - 1), 0.0f, 0.0f, 0};
}

/// The nodes of a map, row by row.
struct Nodes {
  std::vector<float> values;

  float at(std::size_t column, std::size_t row) const {
    return values[std::min(row, kSide - 1) * kSide + std::min(column, kSide - 1)];
  }
};

/// Makes the nodes of a map by `row_of(row, values)`.
Nodes make_nodes(const auto& row_of) {
  Nodes nodes{std::vector<float>(kSide * kSide)};
  tbb::parallel_for(std::size_t{0}, kSide, [&](std::size_t row) {
    row_of(row, std::span(nodes.values).subspan(row * kSide, kSide));
  });
  return nodes;
}

/// Makes the words of a map by `word_of(column, row)`.
std::vector<std::uint32_t> make_words(const auto& word_of) {
  std::vector<std::uint32_t> words(kSide * kSide);
  for (std::size_t row = 0; row < kSide; ++row) {
    for (std::size_t column = 0; column < kSide; ++column) {
      words[row * kSide + column] = word_of(column, row);
    }
  }
  return words;
}

/// Returns the words of heights and sets how they are scaled.
std::vector<std::uint32_t> words_of_heights(const Nodes& nodes, AeroShadowMap& place) {
  float low = std::numeric_limits<float>::max(), most = std::numeric_limits<float>::lowest();
  for (const float value : nodes.values) {
    if (value > kSunken) low = std::min(low, value);
    most = std::max(most, value);
  }
  place.low = std::min(low, most);
  place.unit = std::max(most - place.low, 1.0f) / 65535.0f;
  const auto bits = [&](std::size_t column, std::size_t row) {
    const float steps = (nodes.at(column, row) - place.low) / place.unit;
    return static_cast<std::uint32_t>(std::clamp(steps + 0.5f, 0.0f, 65535.0f));
  };
  return make_words([&](std::size_t column, std::size_t row) {
    return bits(column, row) | bits(column, row + 1) << 16;
  });
}

/// Returns the words of shares.
std::vector<std::uint32_t> words_of_shares(const Nodes& nodes) {
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

/// Returns what is left of sunlight behind each node of a row, by the excess of the coverage noise
/// along the row.
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

/// Returns the place of the map of clouds, whose nodes lie at multiples of a cell.
AeroShadowMap place_of_clouds(const AeroCumulus& clouds, const vec3& eye, const SunAxes& axes) {
  const float cell = clouds.size / kCellsPerSize;
  const float x = eye.x - clouds.drift[0], z = eye.z - clouds.drift[1];
  const float towards = std::max(clouds.base - eye.y, 0.0f) / axes.rise;
  const float half = 0.5f * static_cast<float>(kSide);
  return {cell * (std::round((axes.u(x, z) + towards) / cell) - half),
          cell * (std::round(axes.v(x, z) / cell) - half),
          cell,
          0.0f,
          0.0f,
          0};
}

}  // namespace

ShadowMap land_shadows(const mesh::GridMesh& ground, const vec3& place, const vec3& sun) {
  const SunAxes axes(sun);
  const Heights heights(ground);
  ShadowMap map;
  map.place = place_over(heights, place, axes);
  const float fall = map.place.cell * axes.rise;
  const Nodes nodes = make_nodes([&](std::size_t row, std::span<float> values) {
    const float v = map.place.v + static_cast<float>(row) * map.place.cell;
    float hidden = kNoGround;
    for (std::size_t i = values.size(); i-- > 0;) {
      const float u = map.place.u + static_cast<float>(i) * map.place.cell;
      const float height = heights(axes.x(u, v) - place.x, axes.z(u, v) - place.z) + place.y;
      hidden = std::max(hidden - fall, height);
      values[i] = hidden;
    }
  });
  map.words = words_of_heights(nodes, map.place);
  return map;
}

ShadowMap cloud_shadows(const AeroCumulus& clouds, const vec3& eye, const vec3& sun) {
  const SunAxes axes(sun);
  ShadowMap map;
  map.place = place_of_clouds(clouds, eye, axes);
  const CloudRows rows(clouds, axes, map.place);
  const float reach = CUMULUS_TALLEST * clouds.thickness / (axes.rise * map.place.cell);
  const std::size_t columns = kSide + static_cast<std::size_t>(reach) + 2;
  const Nodes nodes = make_nodes([&](std::size_t row, std::span<float> values) {
    std::vector<float> excess(columns);
    rows(row, excess);
    shade_row(clouds, axes, map.place.cell, excess, values);
  });
  map.words = words_of_shares(nodes);
  const double sum = std::accumulate(nodes.values.begin(), nodes.values.end(), 0.0);
  map.mean = static_cast<float>(sum / static_cast<double>(nodes.values.size()));
  return map;
}

namespace {

void add_land(const mesh::GridMesh& ground, std::uint64_t revision, ShadowCache& cache,
              PackedScene& packed) {
  AeroAirShadows& shadows = packed.numbers.air.shadows;
  const vec3 place = vec_of(packed.numbers.place);
  const vec3 sun = vec_of(packed.numbers.sky.sun_direction);
  const auto map = cache.land.get({revision, place, sun}, [&] {
    return std::make_shared<const ShadowMap>(land_shadows(ground, place, sun));
  });
  shadows.land = map->place;
  shadows.land.first = packed.texels.add(map, map->words);
  shadows.land_softness = kLandSoftness * map->place.cell;
  shadows.top =
      std::max(shadows.top, map->place.low + 65535.0f * map->place.unit + shadows.land_softness);
  shadows.by_land = 1;
}

/// Returns how many points of a step are looked at: the more, the more of what is seen is air.
std::uint32_t points_of(const AeroAir& air) {
  if (air.fog.extinction > 0.0f) return kMostPoints;
  const float points = std::ceil(air.haze_extinction[1] * kClearWay);
  return static_cast<std::uint32_t>(std::clamp(points, 1.0f, static_cast<float>(kMostPoints)));
}

void add_clouds(const vec3& eye, ShadowCache& cache, PackedScene& packed) {
  AeroAirShadows& shadows = packed.numbers.air.shadows;
  const AeroCumulus& clouds = packed.numbers.sky.cumulus;
  const vec3 sun = vec_of(packed.numbers.sky.sun_direction);
  const SunAxes axes(sun);
  const AeroShadowMap place = place_of_clouds(clouds, eye, axes);
  const auto map = cache.clouds.get(
      {clouds.base, clouds.thickness, clouds.size, clouds.threshold, clouds.seed, sun, place.u,
       place.v},
      [&] { return std::make_shared<const ShadowMap>(cloud_shadows(clouds, eye, sun)); });
  shadows.clouds = map->place;
  shadows.clouds.u += axes.u(clouds.drift[0], clouds.drift[1]);
  shadows.clouds.v += axes.v(clouds.drift[0], clouds.drift[1]);
  shadows.clouds.first = packed.texels.add(map, map->words);
  shadows.cloud_base = clouds.base;
  shadows.cloud_top = clouds.base + CUMULUS_TALLEST * clouds.thickness;
  shadows.cloud_slant = 1.0f / axes.rise;
  shadows.cloud_mean = map->mean;
  shadows.top = std::max(shadows.top, shadows.cloud_top);
  shadows.by_clouds = 1;
}

}  // namespace

void add_air_shadows(const mesh::GridMesh* ground, std::uint64_t revision, const vec3& eye,
                     ShadowCache& cache, PackedScene& packed) {
  const AeroSky& sky = packed.numbers.sky;
  if (sky.is_even != 0 || sky.sun_shadows == 0) return;
  const SunAxes axes(vec_of(sky.sun_direction));
  packed.numbers.air.shadows.points = points_of(packed.numbers.air);
  packed.numbers.air.shadows.sun[0] = axes.along.x;
  packed.numbers.air.shadows.sun[1] = axes.along.y;
  if (ground != nullptr && axes.level > kLeastLevel) add_land(*ground, revision, cache, packed);
  if (sky.cumulus.extinction > 0.0f && sky.sun_direction[1] > kLowestCloudSun) {
    add_clouds(eye, cache, packed);
  }
}

}  // namespace aerostat::pack
