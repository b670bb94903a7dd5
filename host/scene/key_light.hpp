#pragma once

#include "core/math.hpp"

namespace aerostat::scene {

struct Scene;

/// The light by which the land casts its shadows: the sun, or the moon when the sun is well down.
struct KeyLight {
  dvec3 direction{0.0, 1.0, 0.0};  // unit vector towards it
  dvec3 irradiance{0.0};           // outside the air, on a plane that faces it
  bool is_moon = false;
};

/// Returns the key light of a scene. The moon takes over at a sun of -4 degrees: from there on the
/// sun itself shines on no landscape and no cloud of the lower 15 km, and its twilight is a hundred
/// times as bright as the full moon, so that nothing is seen to change at once.
KeyLight key_light(const Scene& scene);

}  // namespace aerostat::scene
