#pragma once

#include "core/math.hpp"

/// White balance chooses which light is shown as white.
namespace aerostat::image {

/// Returns the colour of a black body at 1667 to 25000 K, in linear Rec. 709 with luminance 1.
/// Source: B. Kim et al., "Design of advanced color temperature control system for HDTV
/// applications", 2002.
dvec3 black_body(double kelvin);

/// Returns the matrix that turns `white` into a grey of the same luminance, for colours in linear
/// Rec. 709. `degree` 0 leaves all colours as they are, and 1 removes all of the hue of `white`.
/// The responses of the cones are scaled (J. von Kries, with Bradford's matrix).
glm::dmat3 white_balance(const dvec3& white, double degree);

/// Returns the matrix for light of a colour temperature. 6504 K is the white of Rec. 709.
glm::dmat3 white_balance_for(double kelvin);

/// Returns the matrix that goes half of the way to the daylight of a scene, so that a low sun
/// keeps some of its warmth. Returns the unit matrix for light without luminance. The half was
/// chosen by eye.
glm::dmat3 automatic_white_balance(const dvec3& daylight);

}  // namespace aerostat::image
