#pragma once

#include <cstdint>

#include "core/math.hpp"

/// From linear radiance to 8-bit display values, one value at a time.
namespace aerostat::image {

/// Relative luminance of a colour in linear Rec. 709. Source: Rec. ITU-R BT.709.
inline double luminance(const dvec3& c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

/// The tone curve: exposed linear value, >= 0, to linear display value in [0, 1]. Strictly
/// increasing up to the white point, 1 from there on. y = x^a / (b x^(ad) + c) with contrast a and
/// shoulder d; b and c follow from 0.18 -> 0.19 and white point -> 1. Source: T. Lottes, "Advanced
/// Techniques and Optimization of HDR Color Pipelines", GDC 2016.
double tone_curve(double x);

/// The exposed value from which on tone_curve gives 1.
inline constexpr double kWhitePoint = 6.0;

/// The tone curve on a colour (linear Rec. 709; negative and NaN components count as 0). The
/// largest component follows tone_curve, the ratios of the components are kept, so that hue does
/// not turn; near white they tend to 1, so that highlights lose their colour gently. Greys stay
/// grey.
dvec3 tone_map(const dvec3& exposed);

/// The sRGB transfer function (IEC 61966-2-1), linear [0, 1] to encoded [0, 1]; clamps.
double srgb_from_linear(double linear);

/// Its inverse; clamps.
double linear_from_srgb(double encoded);

/// An encoded value in [0, 1] as 8 bits, dithered by an 8x8 Bayer matrix (B. E. Bayer, "An optimum
/// method for two-level rendition of continuous-tone pictures", ICC 1973) of +-0.5 steps: over a
/// block of 8x8 pixels the mean is right to 1/64 step, and 0 and 1 stay what they are.
std::uint8_t quantise(double encoded, int x, int y);

/// What quantise adds to 255 times the value before it cuts off the fraction.
double dither_threshold(int x, int y);

}  // namespace aerostat::image
