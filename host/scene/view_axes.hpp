#pragma once

#include "core/math.hpp"

namespace aerostat::scene {

struct Camera;

/// Unit vectors at right angles to each other that point right, up and ahead in the picture. For
/// a panorama, `up` is the camera's up vector, and `right` and `forward` are at right angles to
/// it.
struct ViewAxes {
  dvec3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, forward{0.0, 0.0, -1.0};
};

/// Returns the axes of a camera that has a position and a target. An up vector within a
/// millionth of a radian of the view says nothing about the picture, and y is up instead. For a
/// view straight down or up, the picture is that of somebody who looks north and tilts the head.
/// North is then at the top for a view down and south for a view up, and east is on the right.
/// Throws Error{bad_data} if the target is the position.
ViewAxes view_axes(const Camera& camera);

}  // namespace aerostat::scene
