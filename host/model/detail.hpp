#pragma once

#include "scene/pixel_size.hpp"
#include "scene/scene.hpp"

namespace aerostat::model {

/// How fine a balloon is built: how far facets may lie from the surfaces they stand for, in metres.
/// 0 is as fine as the models get, and thin things as thin as they are.
struct Detail {
  double envelope_m = 0.0;  // envelope and skirt
  double basket_m = 0.0;    // all below them

  bool operator==(const Detail&) const = default;
};

/// What suffices for an eye in a picture whose pixels have this size: an eighth of a pixel at the
/// nearest point of either, rounded down to a power of two of a metre, so that a small step of the
/// camera changes nothing, and to 0 below a quarter of a millimetre. It depends on its arguments
/// alone.
Detail detail_for(const scene::Balloon& balloon, const dvec3& eye, const scene::PixelSize& pixel);

/// The least number of sides, `least` to `most`, of a polygon that stands for a circle of `radius`
/// within `tolerance_m`.
int sides_within(double tolerance_m, double radius, int least, int most);

/// The least number of equal steps, 1 to `most`, whose chords stand for an arc of the rise
/// `sagitta_m` within `tolerance_m`.
int steps_within(double tolerance_m, double sagitta_m, int most);

/// The radius of a wire that is seen: no thinner than a quarter to half of a pixel, lest the
/// samples of a picture meet it here and miss it there, and yet at most 5 cm.
double seen_radius(double radius, const Detail& detail);

}  // namespace aerostat::model
