#pragma once

#include "core/math.hpp"

namespace aerostat::scatter {

/// An object that stands among the plants or hovers above them. Plants leave room for it, and those
/// around it matter to a picture that shows it.
struct Obstacle {
  dvec3 position{0.0};  // its foot, in world coordinates
  double width_m = 0.0;
  bool above_ground = false;  // y counts from the ground below the object

  bool operator==(const Obstacle&) const = default;
};

/// Plants may grow below objects that are at least this high above the ground, in metres.
inline constexpr double kClear_m = 45.0;

/// The radius in metres of the circle around an eye in which nothing grows.
inline constexpr double kRoomOfEye_m = 5.0;

/// Returns the radius of the circle around an object of this width in which nothing grows.
inline constexpr double room_of(double width_m) {
  return 0.6 * width_m + 3.0;
}

/// The side in metres of the squares in plan by which the plants around an obstacle are chosen. An
/// obstacle that moves within its square needs no other plants.
inline constexpr double kObstacleSquare_m = 16.0;

/// Returns the middle of the square in which an obstacle is, in world coordinates.
inline dvec2 square_of(const Obstacle& obstacle) {
  const dvec2 place(obstacle.position.x, obstacle.position.z);
  return kObstacleSquare_m * (glm::floor(place / kObstacleSquare_m) + 0.5);
}

}  // namespace aerostat::scatter
