#pragma once

#include "core/math.hpp"

/// White balance: which light comes out white.
namespace aerostat::image {

/// Linear Rec. 709 of luminance 1 of a black body at 1667 to 25000 K. Source: B. Kim et al.,
/// "Design of advanced color temperature control system for HDTV applications", 2002.
dvec3 black_body(double kelvin);

/// What a picture's linear Rec. 709 is multiplied by for `white` to become a grey of the same
/// luminance; `degree` 0 leaves it as it is, 1 takes all of its hue. The cones' responses are
/// scaled (J. von Kries, with Bradford's matrix).
glm::dmat3 white_balance(const dvec3& white, double degree);

/// The same for light of a colour temperature; 6504 K is what Rec. 709 calls white.
glm::dmat3 white_balance_for(double kelvin);

/// Half of the way to the daylight of a scene: a low sun keeps some of its warmth. Nothing for
/// light that has no luminance.
glm::dmat3 automatic_white_balance(const dvec3& daylight);

}  // namespace aerostat::image
