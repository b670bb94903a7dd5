#include "geo/transform.hpp"

#include "core/error.hpp"

namespace aerostat::geo {

double curvature_drop(double distance_m) {
  return distance_m * distance_m * (1.0 - kRefraction) / (2.0 * kEarthRadius_m);
}

}  // namespace aerostat::geo
