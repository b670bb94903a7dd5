#pragma once

#include <functional>

#include "core/math.hpp"
#include "scene/scene.hpp"

/// How the camera moves, as functions of where it is. Angles in radians, lengths in metres.
namespace aerostat::viewer {

/// Where the eye is and what it looks at; above the sea.
struct Pose {
  dvec3 position{0.0};
  dvec3 target{0.0, 0.0, -1.0};
};

/// Steps of a flight, -1 to 1 each.
struct Flight {
  double forward = 0.0, right = 0.0, up = 0.0;
  bool is_still() const { return forward == 0.0 && right == 0.0 && up == 0.0; }
};

using HeightAt = std::function<double(double x, double z)>;

/// The least height of the eye above the ground or the sea.
inline constexpr double kEyeClearance_m = 2.0;

/// Turns the eye around the target: `right` moves the picture's content to the right, `down` down.
/// The eye never goes over the poles.
Pose orbit(const Pose& pose, double right_rad, double down_rad);

/// Turns the view about the eye, likewise.
Pose look(const Pose& pose, double right_rad, double down_rad);

/// Goes towards the target, whose distance becomes `factor` times what it was, at least 0.5 m.
Pose dolly(const Pose& pose, double factor);

/// Moves eye and target: forward where it looks, right level, up upright.
Pose fly(const Pose& pose, const Flight& flight, double distance_m);

/// Lifts the eye, and the target with it, out of the ground.
Pose above_ground(const Pose& pose, const HeightAt& height);

/// Metres per second that suit a flight at this height above ground.
double flight_speed(double height_m);

/// A ray of the picture; distances of a film count along it.
struct Sight {
  dvec3 origin{0.0};
  dvec3 direction{0.0, 0.0, -1.0};  // unit
};

/// What is seen at a point of the picture, (0, 0) its left upper, (1, 1) its right lower corner; a
/// thin lens through its middle.
Sight sight_at(const scene::Camera& camera, double aspect, double x, double y);

}  // namespace aerostat::viewer
