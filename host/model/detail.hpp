#pragma once

#include "scene/balloon.hpp"
#include "scene/pixel_size.hpp"

namespace aerostat::model {

/// The tolerances of a balloon's model: the largest distances in metres between its facets and the
/// surfaces that they stand for. With 0 the model is as fine as it can be, and thin things have
/// their true thickness.
struct Detail {
  /// The tolerance of the envelope and the skirt.
  double envelope_m = 0.0;
  /// The tolerance of everything below the skirt.
  double basket_m = 0.0;

  bool operator==(const Detail&) const = default;
};

/// Returns the tolerances that suffice for an eye and a picture whose pixels have this size. A
/// tolerance is an eighth of a pixel at the nearest point, rounded down to a power of two of a
/// metre, so that a small step of the camera changes nothing. It is 0 below a quarter of a
/// millimetre. The result depends only on the arguments.
Detail detail_for(const scene::Balloon& balloon, const dvec3& eye, const scene::PixelSize& pixel);

/// Returns the least number of sides, `least` to `most`, of a polygon that stands for a circle of
/// `radius` within `tolerance_m`.
int sides_within(double tolerance_m, double radius, int least, int most);

/// Returns the least number of equal steps, 1 to `most`, whose chords stand for an arc with the
/// rise `sagitta_m` within `tolerance_m`.
int steps_within(double tolerance_m, double sagitta_m, int most);

/// Returns the radius with which a wire is drawn. It is at least a quarter to a half of a pixel,
/// because the samples of a picture would hit a thinner wire in some pixels and miss it in others.
/// No wire is thickened beyond 5 cm.
double seen_radius(double radius, const Detail& detail);

}  // namespace aerostat::model
