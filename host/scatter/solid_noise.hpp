#pragma once

#include <array>
#include <cstdint>

#include "core/math.hpp"

namespace aerostat::scatter {

/// The number of points in a block. Points are processed in blocks, so that the inner loops run
/// over plain arrays. Every value is computed by itself and does not depend on how points are
/// grouped.
inline constexpr int kBlockSize = 128;
using Block = std::array<float, kBlockSize>;

/// Up to kBlockSize points in space, in metres. The entries beyond `count` are unused, but they are
/// numbers.
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

/// The fBm of noise in space that kernels/device/noise/solid_noise.clh defines. It equals
/// filtered_solid_fbm there except for rounding. Each octave has half the wavelength and `gain`
/// times the amplitude of the one before. Octaves whose wavelength is less than two to four times
/// `footprint` metres are faded out. `ridges` folds each octave at zero.
struct SolidFbm {
  std::uint32_t seed = 0;
  float wavelength_m = 1.0f;
  int octaves = 1;
  float gain = 0.5f;
  bool ridges = false;

  /// Fills one value for each spot.
  void at(const Spots& spots, float footprint, Block& values) const;
  /// Returns a lower bound of the value for every footprint. `most` returns an upper bound.
  float least() const;
  float most() const;
};

}  // namespace aerostat::scatter
