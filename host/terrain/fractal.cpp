#include "fractal.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/simd.hpp"

namespace aerostat::terrain {
namespace {

constexpr float kNoiseScale = 1.0f / static_cast<float>(kNoiseBound);

float amplitude_sum(const std::vector<Octave>& octaves) {
  float sum = 0.0f;
  for (const Octave& octave : octaves) sum += octave.amplitude;
  return sum > 0.0f ? sum : 1.0f;
}

/// The least and the greatest of some values that are not negative.
struct Range {
  float least = 0.0f, most = 0.0f;
};

Range range_of(const Block& values, int count) {
  Range range;
  in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
    // The bits have the same order as the values, and compilers can vectorise the least of
    // integers.
    std::int32_t least = std::numeric_limits<std::int32_t>::max(), most = 0;
    for (int i = 0; i < count; ++i) {
      least = std::min(least, std::bit_cast<std::int32_t>(values[i]));
      most = std::max(most, std::bit_cast<std::int32_t>(values[i]));
    }
    range = {std::bit_cast<float>(least), std::bit_cast<float>(most)};
  });
  return range;
}

/// Computes the share of a layer at each point, whose spacings lie in `range`. Returns false if
/// the layer vanishes everywhere.
bool band_shares(const NoiseLayer& layer, const Points& points, const Range& range, Block& share) {
  const float wavelength_m = layer.wavelength_m;
  if (band_share(wavelength_m, range.least) <= 0.0f) {
    std::fill_n(share.begin(), points.count, 0.0f);
    return false;
  }
  if (band_share(wavelength_m, range.most) >= 1.0f) {
    std::fill_n(share.begin(), points.count, 1.0f);
    return true;
  }
  in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
    for (int i = 0; i < points.count; ++i) share[i] = band_share(wavelength_m, points.spacing[i]);
  });
  return true;
}

}  // namespace

std::vector<Octave> make_octaves(const scene::Fractal& fractal, double first_m,
                                 std::uint32_t seed) {
  std::vector<Octave> octaves(static_cast<std::size_t>(std::max(fractal.octaves, 0)));
  double wavelength = first_m;
  double amplitude = 1.0;
  for (std::size_t i = 0; i < octaves.size(); ++i) {
    octaves[i].layer = make_layer(wavelength, seed, static_cast<std::uint32_t>(i));
    octaves[i].amplitude = static_cast<float>(amplitude);
    wavelength /= fractal.lacunarity;
    amplitude *= fractal.gain;
  }
  return octaves;
}

std::vector<Octave> make_soft_octaves(double first_m, std::uint32_t seed, int count) {
  scene::Fractal fractal;
  fractal.octaves = count;
  return make_octaves(fractal, first_m, seed);
}

void fbm(const std::vector<Octave>& octaves, const Points& points, Block& value) {
  const float scale = kNoiseScale / amplitude_sum(octaves);
  std::fill_n(value.begin(), points.count, 0.0f);
  const Range spacings = range_of(points.spacing, points.count);
  Block noise;
  Block share;
  for (const Octave& octave : octaves) {
    if (!band_shares(octave.layer, points, spacings, share)) continue;
    sample(octave.layer, points, noise);
    in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
      const float weight = scale * octave.amplitude;
      for (int i = 0; i < points.count; ++i) value[i] += weight * share[i] * noise[i];
    });
  }
}

void fbm(const std::vector<Octave>& octaves, const Points& points, Block& value, Block& dx,
         Block& dz) {
  const float scale = kNoiseScale / amplitude_sum(octaves);
  // Each group of arrays is in one object, so that compilers see that they do not overlap.
  struct {
    Block value, dx, dz;
  } sum, noise;
  const Range spacings = range_of(points.spacing, points.count);
  for (Block* one : {&sum.value, &sum.dx, &sum.dz}) std::fill_n(one->begin(), points.count, 0.0f);
  Block share;
  for (const Octave& octave : octaves) {
    if (!band_shares(octave.layer, points, spacings, share)) continue;
    sample(octave.layer, points, noise.value, noise.dx, noise.dz);
    in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
      const float most = scale * octave.amplitude;
      for (int i = 0; i < points.count; ++i) {
        const float weight = most * share[i];
        sum.value[i] += weight * noise.value[i];
        sum.dx[i] += weight * noise.dx[i];
        sum.dz[i] += weight * noise.dz[i];
      }
    });
  }
  std::copy_n(sum.value.begin(), points.count, value.begin());
  std::copy_n(sum.dx.begin(), points.count, dx.begin());
  std::copy_n(sum.dz.begin(), points.count, dz.begin());
}

void ridged(const std::vector<Octave>& octaves, float offset, const Points& points, Block& value) {
  // A faded octave is replaced by its mean, so that distant ground does not sink.
  const float mean = (offset - 0.25f) * (offset - 0.25f);
  const float scale = 1.0f / (amplitude_sum(octaves) * std::max(offset * offset, 1e-3f));
  std::fill_n(value.begin(), points.count, 0.0f);
  const Range spacings = range_of(points.spacing, points.count);
  Block noise{};
  Block share;
  Block weight;
  std::fill_n(weight.begin(), points.count, 1.0f);
  for (const Octave& octave : octaves) {
    if (band_shares(octave.layer, points, spacings, share)) sample(octave.layer, points, noise);
    in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
      const float most = scale * octave.amplitude, middle = mean, from = offset;
      for (int i = 0; i < points.count; ++i) {
        const float ridge = from - std::fabs(kNoiseScale * noise[i]);
        const float signal = (middle + share[i] * (ridge * ridge - middle)) * weight[i];
        value[i] += most * signal;
        weight[i] = std::clamp(2.0f * signal, 0.0f, 1.0f);
      }
    });
  }
}

Distortion::Distortion(double amplitude_m, double wavelength_m, std::uint32_t seed, int octaves)
    : amplitude_m_(static_cast<float>(amplitude_m)),
      x_(make_soft_octaves(wavelength_m, seed, octaves)),
      z_(make_soft_octaves(wavelength_m, seed ^ 0x68E31DA4u, octaves)) {}

void Distortion::apply(Points& points) const {
  if (amplitude_m_ == 0.0f) return;
  Block dx;
  Block dz;
  fbm(x_, points, dx);
  fbm(z_, points, dz);
  for (int i = 0; i < points.count; ++i) {
    points.x[i] += amplitude_m_ * dx[i];
    points.z[i] += amplitude_m_ * dz[i];
  }
}

void Distortion::apply(Points& points, Jacobian& jacobian) const {
  Block dx, dz;
  if (amplitude_m_ == 0.0f) {
    for (Block* one : {&jacobian.x_by_x, &jacobian.z_by_z}) one->fill(1.0f);
    for (Block* none : {&jacobian.x_by_z, &jacobian.z_by_x}) none->fill(0.0f);
    return;
  }
  fbm(x_, points, dx, jacobian.x_by_x, jacobian.x_by_z);
  fbm(z_, points, dz, jacobian.z_by_x, jacobian.z_by_z);
  for (int i = 0; i < points.count; ++i) {
    points.x[i] += amplitude_m_ * dx[i];
    points.z[i] += amplitude_m_ * dz[i];
    jacobian.x_by_x[i] = 1.0f + amplitude_m_ * jacobian.x_by_x[i];
    jacobian.x_by_z[i] *= amplitude_m_;
    jacobian.z_by_x[i] *= amplitude_m_;
    jacobian.z_by_z[i] = 1.0f + amplitude_m_ * jacobian.z_by_z[i];
  }
}

}  // namespace aerostat::terrain
