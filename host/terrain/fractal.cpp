#include "fractal.hpp"

#include <algorithm>
#include <cmath>

namespace aerostat::terrain {
namespace {

constexpr float kNoiseScale = 1.0f / static_cast<float>(kNoiseBound);

float amplitude_sum(const std::vector<Octave>& octaves) {
  float sum = 0.0f;
  for (const Octave& octave : octaves) sum += octave.amplitude;
  return sum > 0.0f ? sum : 1.0f;
}

/// Shares of a layer at each point; false if it vanishes at all of them.
bool band_shares(const NoiseLayer& layer, const Points& points, Block& share) {
  float most = 0.0f;
  for (int i = 0; i < points.count; ++i) {
    share[i] = band_share(layer.wavelength_m, points.spacing[i]);
    most = std::max(most, share[i]);
  }
  return most > 0.0f;
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
  Block noise;
  Block share;
  for (const Octave& octave : octaves) {
    if (!band_shares(octave.layer, points, share)) continue;
    sample(octave.layer, points, noise);
    for (int i = 0; i < points.count; ++i)
      value[i] += scale * octave.amplitude * share[i] * noise[i];
  }
}

void fbm(const std::vector<Octave>& octaves, const Points& points, Block& value, Block& dx,
         Block& dz) {
  const float scale = kNoiseScale / amplitude_sum(octaves);
  for (Block* sum : {&value, &dx, &dz}) std::fill_n(sum->begin(), points.count, 0.0f);
  Block noise, noise_dx, noise_dz, share;
  for (const Octave& octave : octaves) {
    if (!band_shares(octave.layer, points, share)) continue;
    sample(octave.layer, points, noise, noise_dx, noise_dz);
    for (int i = 0; i < points.count; ++i) {
      const float weight = scale * octave.amplitude * share[i];
      value[i] += weight * noise[i];
      dx[i] += weight * noise_dx[i];
      dz[i] += weight * noise_dz[i];
    }
  }
}

void ridged(const std::vector<Octave>& octaves, float offset, const Points& points, Block& value) {
  // A faded octave is replaced by its average, so that distant ground does not sink.
  const float mean = (offset - 0.25f) * (offset - 0.25f);
  const float scale = 1.0f / (amplitude_sum(octaves) * std::max(offset * offset, 1e-3f));
  std::fill_n(value.begin(), points.count, 0.0f);
  Block noise{};
  Block share;
  Block weight;
  std::fill_n(weight.begin(), points.count, 1.0f);
  for (const Octave& octave : octaves) {
    if (band_shares(octave.layer, points, share)) sample(octave.layer, points, noise);
    for (int i = 0; i < points.count; ++i) {
      const float ridge = offset - std::fabs(kNoiseScale * noise[i]);
      const float signal = (mean + share[i] * (ridge * ridge - mean)) * weight[i];
      value[i] += scale * octave.amplitude * signal;
      weight[i] = std::clamp(2.0f * signal, 0.0f, 1.0f);
    }
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
