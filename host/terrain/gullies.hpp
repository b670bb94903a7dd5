#pragma once

#include <cstdint>
#include <vector>

#include "points.hpp"

namespace aerostat::terrain {

/// The ground at each point and its gradient (metres per metre).
struct Slopes {
  Block height, dx, dz;
};

/// Gullies and the ribs between them, as running water leaves them on slopes of rock. They are
/// waves across the fall line, with sharp crests and round floors. Each octave follows the fall
/// line of the ground with all octaves before it, so that gullies branch. Every point is computed
/// on its own. Waves are laid around one random point in every square of a lattice and blended
/// where they meet.
class Gullies {
 public:
  /// Takes the distance `widest_m` from rib to rib in metres for the first octave. Each further
  /// octave has half of that. `depth` is the height from crest to floor, relative to the width,
  /// on ground of slope 1.
  Gullies(double widest_m, int octaves, float depth, std::uint32_t seed);

  /// Adds gullies to the ground. `strength` scales their depth at each point. Gullies that are
  /// too fine for a point's spacing are left out.
  void add(const Points& points, const Block& strength, Slopes& ground) const;

 private:
  double widest_m_;
  int octaves_;
  float depth_;
  std::uint32_t seed_;
};

}  // namespace aerostat::terrain
