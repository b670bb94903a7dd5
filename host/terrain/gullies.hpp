#pragma once

#include <cstdint>
#include <vector>

#include "points.hpp"

namespace aerostat::terrain {

/// The ground at each point and its gradient (metres per metre).
struct Slopes {
  Block height, dx, dz;
};

/// Gullies and the ribs between them, as running water leaves them on slopes of rock: waves across
/// the fall line, whose crests are sharp and whose floors are round. Each octave follows the fall
/// line that the octaves before it have made, so that gullies branch. Every point is worked out on
/// its own: waves are laid around one random point in every square of a lattice and blended where
/// they meet.
class Gullies {
 public:
  /// `widest_m` from rib to rib at first, half of that in every further octave; `depth` from crest
  /// to floor, relative to the width on ground of slope 1.
  Gullies(double widest_m, int octaves, float depth, std::uint32_t seed);

  /// Adds them to the ground; `strength` scales their depth at each point. What is too fine for a
  /// point's spacing is left out.
  void add(const Points& points, const Block& strength, Slopes& ground) const;

 private:
  double widest_m_;
  int octaves_;
  float depth_;
  std::uint32_t seed_;
};

}  // namespace aerostat::terrain
