#pragma once

#include <cstdint>

#include "core/array.hpp"
#include "core/math.hpp"

namespace aerostat::image {

/// A rendered picture: linear Rec. 709 radiance and layers that tell what the samples of each
/// pixel hit. Row 0 is the top. Each array has width * height entries, or none if the layer was
/// not asked for.
struct Film {
  int width = 0;
  int height = 0;
  glm::ivec2 first{0, 0};  // position of the first pixel in the whole picture
  glm::ivec2 whole{0, 0};  // size of the whole picture; {0, 0}: that of the film
  Array<vec3> radiance;
  Array<float> alpha;       // share of the samples that hit something
  Array<float> distance_m;  // distance along the ray of the nearest sample; +inf for sky
  Array<vec3> albedo;       // mean over the samples of what surfaces reflect; 0 for sky
  Array<vec3> normal_ws;    // mean over the samples of unit vectors in world space; 0 for sky
  Array<std::uint32_t> object_id;  // scene::ObjectId; 0 for sky
  Array<std::uint32_t> samples;    // samples that each pixel has taken
  double metered_ev = 0.0;         // stops that suit the whole picture, if asked for
  vec3 daylight{1.0f};           // radiance at the eye's height of a white card that faces the sun
  std::uint64_t nan_pixels = 0;  // NaN or infinite pixels, which were set to black
};

}  // namespace aerostat::image
