#include "model/detail.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/envelope_shape.hpp"
#include "model/rigging.hpp"

namespace aerostat::model {
namespace {

/// The tolerance as a share of a pixel. Chosen by eye.
constexpr double kPixelShare = 0.125;
/// The finest tolerance above 0, in metres.
constexpr double kFinest = 0x1p-12;
constexpr double kCoarsest = 16.0;
/// The reach of the basket and its rig from the axis, in metres.
constexpr double kBasketReach = 1.0;
/// The height of the equator above the mouth, in diameters of the envelope.
constexpr double kEquator = 0.60;
constexpr double kCrown = 0.91;
/// The least radius of a wire, in pixels. Chosen by eye.
constexpr double kWireRadius = 0.25;
/// The largest radius to which a wire is thickened, in metres. Chosen by eye.
constexpr double kThickest = 0.05;

double level(double distance, const scene::PixelSize& pixel) {
  const double tolerance = std::min(kPixelShare * pixel.metres(distance), kCoarsest);
  return tolerance < kFinest ? 0.0 : std::exp2(std::floor(std::log2(tolerance)));
}

}  // namespace

Detail detail_for(const scene::Balloon& balloon, const dvec3& eye, const scene::PixelSize& pixel) {
  const dvec3 seen = eye - balloon.position;
  const double radius = 0.5 * balloon.diameter_m, mouth = mouth_height(balloon.diameter_m);
  const double level_reach = std::hypot(seen.x, seen.z);
  const double outside = std::max(seen.y - mouth, 0.0) + std::max(-seen.y, 0.0);
  const double basket = std::hypot(std::max(level_reach - kBasketReach, 0.0), outside);
  const dvec3 middle(0.0, mouth + kEquator * balloon.diameter_m, 0.0);
  // The sphere around the equator stands for the envelope, except for its cone and its flat crown.
  const double ball = std::abs(glm::distance(seen, middle) - radius);
  const double below = glm::distance(seen, {0.0, mouth, 0.0}) - 0.35 * radius;
  const double above = glm::distance(seen, {0.0, mouth + kCrown * balloon.diameter_m, 0.0});
  const double envelope = std::max(std::min({ball, below, above}), 0.0);
  return {level(envelope, pixel), level(basket, pixel)};
}

int sides_within(double tolerance_m, double radius, int least, int most) {
  if (!(tolerance_m > 0.0)) return most;
  if (tolerance_m >= radius) return least;
  const double half = std::acos(1.0 - tolerance_m / radius);
  return std::clamp(static_cast<int>(std::ceil(std::numbers::pi / half)), least, most);
}

int steps_within(double tolerance_m, double sagitta_m, int most) {
  if (!(tolerance_m > 0.0)) return most;
  // The rise of a chord is proportional to the square of its length.
  const double steps = std::ceil(std::sqrt(sagitta_m / tolerance_m));
  return std::clamp(static_cast<int>(std::min(steps, 1e6)), 1, most);
}

double seen_radius(double radius, const Detail& detail) {
  return std::max(radius, std::min(kWireRadius * detail.basket_m / kPixelShare, kThickest));
}

}  // namespace aerostat::model
