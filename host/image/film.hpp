#pragma once

#include <cstdint>

#include "core/array.hpp"
#include "core/math.hpp"

namespace aerostat::image {

/// A picture as it was measured: linear Rec. 709 radiance and, from the samples of each pixel, what
/// lies there. Row 0 is the top; width * height entries each, or none where not asked for.
struct Film {
  int width = 0;
  int height = 0;
  glm::ivec2 first{0, 0};  // its first pixel in the whole picture
  glm::ivec2 whole{0, 0};  // size of that; {0, 0}: the film is all of it
  Array<vec3> radiance;
  Array<float> alpha;              // share of the samples that hit something
  Array<float> distance_m;         // along the ray, nearest sample; +inf for sky
  Array<vec3> normal_ws;           // world space, unit; 0 for sky
  Array<std::uint32_t> object_id;  // scene::ObjectId; 0 for sky
  Array<std::uint32_t> samples;    // that each pixel has taken
  double metered_ev = 0.0;         // stops that suit the whole picture, if asked for
  vec3 daylight{1.0f};           // radiance of a white card that faces the sun, at the eye's height
  std::uint64_t nan_pixels = 0;  // pixels that came out NaN or infinite and were set to black
};

}  // namespace aerostat::image
