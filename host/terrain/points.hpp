#pragma once

#include <array>

namespace aerostat::terrain {

/// Points are evaluated in blocks, so that the inner loops run over plain arrays. Every element is
/// computed on its own: the result does not depend on how points are grouped.
inline constexpr int kBlockSize = 128;

/// One value per point; entries from `Points::count` on are unspecified.
using Block = std::array<float, kBlockSize>;

/// Up to kBlockSize points of the ground in metres, relative to the terrain's centre. `spacing` is
/// the distance of neighbouring samples there; detail too fine for it is faded out. 0 keeps all.
struct Points {
  int count = 0;
  Block x;
  Block z;
  Block spacing;
};

}  // namespace aerostat::terrain
