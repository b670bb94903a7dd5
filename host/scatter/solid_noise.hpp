#pragma once

#include <array>
#include <cstdint>

#include "core/math.hpp"

namespace aerostat::scatter {

/// Points are taken in blocks, so that the inner loops run over plain arrays. Every value is
/// computed on its own: it does not depend on how points are grouped.
inline constexpr int kBlockSize = 128;
using Block = std::array<float, kBlockSize>;

/// Up to kBlockSize points in space, in metres; those beyond `count` are nobody's, but numbers.
struct Spots {
  int count = 0;
  Block x{}, y{}, z{};

  void add(const vec3& p) {
    x[static_cast<std::size_t>(count)] = p.x;
    y[static_cast<std::size_t>(count)] = p.y;
    z[static_cast<std::size_t>(count)] = p.z;
    ++count;
  }
};

/// fBm of the noise in space that kernels/device/noise/solid_noise.clh defines, as
/// filtered_solid_fbm there and the same within rounding: octaves of half the wavelength and `gain`
/// times the amplitude each, those finer than two to four times `footprint` (metres) faded out.
/// `ridges` folds each octave at zero.
struct SolidFbm {
  std::uint32_t seed = 0;
  float wavelength_m = 1.0f;
  int octaves = 1;
  float gain = 0.5f;
  bool ridges = false;

  /// Fills one value for each spot.
  void at(const Spots& spots, float footprint, Block& values) const;
  /// The value lies between these, whatever the footprint.
  float least() const;
  float most() const;
};

}  // namespace aerostat::scatter
