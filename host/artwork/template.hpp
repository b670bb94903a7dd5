#pragma once

#include <string>

#include "scene/balloon.hpp"

namespace aerostat::artwork {

/// Returns an SVG drawing of the unrolled gores of an envelope, side by side as seen from outside,
/// with the first one on the left: their outlines, the seams between their panels, heights along
/// the cloth in metres and the directions from the heading. A unit of the drawing is a metre. The
/// guides are a group of their own, which is not drawn when the file is used as artwork with the
/// wrap "gores".
std::string gores_template(const scene::Balloon& balloon);

}  // namespace aerostat::artwork
