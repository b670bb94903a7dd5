#pragma once

#include "scene/scene.hpp"

namespace aerostat::scene {

/// Unit vectors at right angles to each other: what lies right, up and ahead in the picture. Of a
/// panorama: right and ahead are level with respect to its up vector, which stays as it is.
struct ViewAxes {
  dvec3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, forward{0.0, 0.0, -1.0};
};

/// The axes of a camera whose position and target are resolved and apart. An up vector that points
/// along the view, within a millionth of a radian, says nothing about the picture; y is up then,
/// and for a view straight down or up the picture is that of somebody who looks north and tilts the
/// head: north is at its top for a view down, south for a view up, and east is on the right. Throws
/// Error{bad_data} if the target is the position.
ViewAxes view_axes(const Camera& camera);

}  // namespace aerostat::scene
