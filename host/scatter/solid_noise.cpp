#include "scatter/solid_noise.hpp"

#include <algorithm>
#include <cmath>

#include "core/simd.hpp"

namespace aerostat::scatter {
namespace {

/// The bound of the noise with these gradients.
constexpr float kBound = 1.04f;

AEROSTAT_INLINE std::uint32_t hash_column(std::uint32_t seed, std::int32_t ix) {
  std::uint32_t h = (static_cast<std::uint32_t>(ix) * 0x9E3779B1u) ^ (seed * 0x85EBCA6Bu);
  h ^= h >> 16;
  h *= 0x7FEB352Du;
  return h ^ (h >> 15);
}

/// Returns the product of the vector (x, y, z) with a gradient. The gradient points to the middle
/// of one of a cube's twelve edges.
AEROSTAT_INLINE float corner_ramp(std::uint32_t bits, float x, float y, float z) {
  std::uint32_t hash = (bits ^ (bits >> 16)) * 0x7FEB352Du;
  hash ^= hash >> 15;
  const std::uint32_t axis = ((hash >> 16) * 3u) >> 16;
  const float first = axis == 0u ? y : x;
  const float second = axis == 2u ? y : z;
  const float sign_a = 1.0f - static_cast<float>(static_cast<std::int32_t>((hash & 1u) << 1));
  const float sign_b = 1.0f - static_cast<float>(static_cast<std::int32_t>(hash & 2u));
  return sign_a * first + sign_b * second;
}

AEROSTAT_INLINE float fade(float t) {
  return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

/// Moves a coordinate onto the lattice. This works for every number and for NaN. The noise is 0
/// long before the rim of the lattice.
AEROSTAT_INLINE float on_lattice(float x) {
  constexpr float kRim = 1 << 30;
  const float above = x > -kRim ? x : -kRim;
  return above < kRim ? above : kRim;
}

/// Rounds down. |x| must be less than 2^31.
AEROSTAT_INLINE std::int32_t floor_int(float x) {
  const auto whole = static_cast<std::int32_t>(x);
  return whole - static_cast<std::int32_t>(static_cast<float>(whole) > x);
}

AEROSTAT_INLINE float solid_noise(float any_x, float any_y, float any_z, std::uint32_t seed) {
  const float x = on_lattice(any_x), y = on_lattice(any_y), z = on_lattice(any_z);
  const std::int32_t ix = floor_int(x), iy = floor_int(y), iz = floor_int(z);
  const float tx = x - static_cast<float>(ix), ty = y - static_cast<float>(iy),
              tz = z - static_cast<float>(iz);
  const std::uint32_t left = hash_column(seed, ix), right = hash_column(seed, ix + 1);
  const std::uint32_t y0 = static_cast<std::uint32_t>(iy) * 0xC2B2AE35u, y1 = y0 + 0xC2B2AE35u;
  const std::uint32_t z0 = static_cast<std::uint32_t>(iz) * 0x27D4EB2Fu, z1 = z0 + 0x27D4EB2Fu;
  const float wx = fade(tx);
  const auto edge = [&](std::uint32_t line, float dy, float dz) {
    const float a = corner_ramp(left ^ line, tx, dy, dz);
    const float b = corner_ramp(right ^ line, tx - 1.0f, dy, dz);
    return a + (b - a) * wx;
  };
  const float e00 = edge(y0 + z0, ty, tz);
  const float e10 = edge(y1 + z0, ty - 1.0f, tz);
  const float e01 = edge(y0 + z1, ty, tz - 1.0f);
  const float e11 = edge(y1 + z1, ty - 1.0f, tz - 1.0f);
  const float wy = fade(ty);
  const float front = e00 + (e10 - e00) * wy;
  const float rear = e01 + (e11 - e01) * wy;
  return front + (rear - front) * fade(tz);
}

/// One octave of a fractal. It adds weight * noise(spot * scale + shift) to the values.
struct Octave {
  float weight, scale, shift;
  std::uint32_t seed;
  bool ridges;
};

// The number of spots that are computed at a time. Rounding the count up costs less than computing
// the rest of a block one by one, which would take as long as the whole block.
constexpr int kAtOnce = 16;
static_assert(kBlockSize % kAtOnce == 0);

// Adds an octave to `values`. The noise is written to a local array, because the compiler could not
// vectorise writes that might change the spots.
AEROSTAT_INLINE void octave_loop(const Octave& octave, const Spots& spots, Block& values) {
  const Octave o = octave;
  const int count = (spots.count + kAtOnce - 1) / kAtOnce * kAtOnce;
  Block noise;
  for (int i = 0; i < count; ++i) {
    noise[i] = solid_noise(spots.x[i] * o.scale + o.shift, spots.y[i] * o.scale + o.shift,
                           spots.z[i] * o.scale + o.shift, o.seed);
  }
  for (int i = 0; i < count; ++i) {
    values[i] += o.weight * (o.ridges ? 0.5f - 2.0f * std::fabs(noise[i]) : noise[i]);
  }
}

float resolved(float wavelength, float footprint) {
  return std::clamp(wavelength / (2.0f * footprint) - 1.0f, 0.0f, 1.0f);
}

/// Returns the sum of the amplitudes of a fractal's octaves.
float amplitudes(const SolidFbm& fbm) {
  float sum = 0.0f, amplitude = 1.0f;
  for (int i = 0; i < fbm.octaves; ++i, amplitude *= fbm.gain) sum += amplitude;
  return sum;
}

}  // namespace

void SolidFbm::at(const Spots& spots, float footprint, Block& values) const {
  values.fill(0.0f);
  float amplitude = 1.0f, wavelength = wavelength_m;
  for (int i = 0; i < octaves; ++i) {
    const float weight = amplitude * resolved(wavelength, footprint);
    if (!(weight > 0.0f)) break;
    const Octave octave{weight, 1.0f / wavelength, 0.37f * static_cast<float>(i + 1),
                        seed + static_cast<std::uint32_t>(i), ridges};
    in_vectors([&]() AEROSTAT_INLINE_LAMBDA { octave_loop(octave, spots, values); });
    wavelength *= 0.5f;
    amplitude *= gain;
  }
}

float SolidFbm::least() const {
  return (ridges ? 0.5f - 2.0f * kBound : -kBound) * amplitudes(*this);
}

float SolidFbm::most() const {
  return (ridges ? 0.5f : kBound) * amplitudes(*this);
}

}  // namespace aerostat::scatter
