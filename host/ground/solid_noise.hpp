#pragma once

#include <array>

#include "core/math.hpp"
#include "rules/solid_noise.h"

namespace aerostat::ground {

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

/// Fills the value of an fBm at each spot. It equals filtered_solid_fbm of
/// kernels/device/noise/solid_noise.clh except for rounding. Octaves whose wavelength is less than
/// two to four times `footprint` metres are faded out.
void fill_values(const rules::SolidFbm& fbm, const Spots& spots, float footprint, Block& values);

/// Returns an upper bound of the value of an fBm for every footprint.
float most_of(const rules::SolidFbm& fbm);

}  // namespace aerostat::ground
