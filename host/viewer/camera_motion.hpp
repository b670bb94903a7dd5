#pragma once

#include <functional>
#include <optional>

#include "core/math.hpp"
#include "scene/picture.hpp"

/// Computes movements of the camera as functions of its pose. Angles are in radians, lengths in
/// metres.
namespace aerostat::viewer {

/// The position of the eye and the target it looks at, both in heights above the sea.
struct Pose {
  dvec3 position{0.0};
  dvec3 target{0.0, 0.0, -1.0};
};

/// The directions of a flight, each from -1 to 1.
struct Flight {
  double forward = 0.0, right = 0.0, up = 0.0;
  bool is_still() const { return forward == 0.0 && right == 0.0 && up == 0.0; }
};

using HeightAt = std::function<double(double x, double z)>;

/// The least height of the eye above the ground or the sea, in metres. Chosen by eye.
inline constexpr double kEyeClearance_m = 2.0;

/// Turns the eye around the target. `right_rad` moves the picture's content to the right, and
/// `down_rad` moves it down. The eye never goes over the poles.
Pose orbit(const Pose& pose, double right_rad, double down_rad);

/// Turns the view about the eye. `right_rad` moves the picture's content to the right, and
/// `down_rad` moves it down. The view never turns over the poles.
Pose look(const Pose& pose, double right_rad, double down_rad);

/// Moves the eye towards the target. The distance between them is multiplied by `factor`, but stays
/// at least 0.5 m.
Pose dolly(const Pose& pose, double factor);

/// Moves the eye and the target together. Forward is the direction of view, right is level, and up
/// is vertical.
Pose fly(const Pose& pose, const Flight& flight, double distance_m);

/// Lifts the eye and the target out of the ground by the same height.
Pose above_ground(const Pose& pose, const HeightAt& height);

/// Returns a speed in metres per second that suits a flight at this height above the ground.
double flight_speed(double height_m);

/// A ray through a point of the picture. The distances of a film count along it.
struct Sight {
  dvec3 origin{0.0};
  /// The direction as a unit vector.
  dvec3 direction{0.0, 0.0, -1.0};
};

/// Returns the ray through a point of the picture. (0, 0) is the upper left corner and (1, 1) the
/// lower right one. The ray of a thin lens goes through the middle of the lens.
Sight sight_at(const scene::Camera& camera, double aspect, double x, double y);

/// Returns the place in the picture of a point in the world, the inverse of `sight_at`, or nothing
/// if the point is outside of the picture or behind the camera.
std::optional<dvec2> place_in_picture(const scene::Camera& camera, double aspect,
                                      const dvec3& point);

}  // namespace aerostat::viewer
