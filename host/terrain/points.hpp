#pragma once

#include <array>

namespace aerostat::terrain {

/// The size of the blocks in which points are evaluated, so that inner loops run over plain
/// arrays. Every element is computed on its own, so that the result does not depend on the
/// grouping of points.
inline constexpr int kBlockSize = 128;

/// One value for each point. Entries from `Points::count` on are unspecified.
using Block = std::array<float, kBlockSize>;

/// Up to kBlockSize points of the ground, in metres relative to the terrain's centre. `spacing`
/// is the distance between neighbouring samples there. Detail that is too fine for it is faded
/// out. A spacing of 0 keeps all detail.
struct Points {
  int count = 0;
  Block x;
  Block z;
  Block spacing;
};

}  // namespace aerostat::terrain
