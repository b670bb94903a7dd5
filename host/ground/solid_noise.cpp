#include "ground/solid_noise.hpp"

#include <cmath>
#include <cstdint>

#include "core/simd.hpp"

namespace aerostat::ground {
namespace {

/// The bound of the noise with these gradients.
constexpr float kBound = 1.04f;

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
  return rules::solid_noise_in_cell(ix, iy, iz, x - static_cast<float>(ix),
                                    y - static_cast<float>(iy), z - static_cast<float>(iz), seed);
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
    values[i] += o.weight * (o.ridges ? rules::folded(noise[i]) : noise[i]);
  }
}

/// Returns the sum of the amplitudes of a fractal's octaves.
float amplitudes(const rules::SolidFbm& fbm) {
  float sum = 0.0f, amplitude = 1.0f;
  for (int i = 0; i < fbm.octaves; ++i, amplitude *= fbm.gain) sum += amplitude;
  return sum;
}

}  // namespace

void fill_values(const rules::SolidFbm& fbm, const Spots& spots, float footprint, Block& values) {
  values.fill(0.0f);
  float amplitude = 1.0f, wavelength = fbm.wavelength;
  for (int i = 0; i < fbm.octaves; ++i) {
    const float weight = amplitude * rules::resolved(wavelength, footprint);
    if (!(weight > 0.0f)) break;
    const Octave octave{weight, 1.0f / wavelength, rules::octave_shift(i),
                        fbm.seed + static_cast<std::uint32_t>(i), fbm.ridges != 0};
    in_vectors([&]() AEROSTAT_INLINE_LAMBDA { octave_loop(octave, spots, values); });
    wavelength *= 0.5f;
    amplitude *= fbm.gain;
  }
}

float most_of(const rules::SolidFbm& fbm) {
  return (fbm.ridges != 0 ? rules::folded(0.0f) : kBound) * amplitudes(fbm);
}

}  // namespace aerostat::ground
