#pragma once

#include <cstdint>

#include "core/math.hpp"

/// These functions turn linear radiance into 8-bit display values, one value at a time.
namespace aerostat::image {

/// Returns the relative luminance of a colour in linear Rec. 709. Source: Rec. ITU-R BT.709.
inline double luminance(const dvec3& c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

/// Maps an exposed linear value, >= 0, to a linear display value in [0, 1]. The tone curve is
/// strictly increasing up to the white point, and 1 from there on:
///   y = x^a / (b x^(ad) + c)
/// The contrast a is 1.55 and the shoulder d is 0.98. The curve maps 0.18 to 0.19 and the white
/// point to 1, which gives b and c. Source: T. Lottes, "Advanced Techniques and Optimization of
/// HDR Color Pipelines", GDC 2016.
double tone_curve(double x);

/// The least exposed value that tone_curve maps to 1.
inline constexpr double kWhitePoint = 6.0;

/// Applies the tone curve to a colour in linear Rec. 709. Negative and NaN components count as 0.
/// The largest component follows tone_curve. The ratios of the components are kept, so that the
/// hue does not turn. Near white the ratios tend to 1, so that highlights lose their colour
/// gently. Greys stay grey.
dvec3 tone_map(const dvec3& exposed);

/// Maps linear [0, 1] to encoded [0, 1] by the sRGB transfer function (IEC 61966-2-1). Clamps.
double srgb_from_linear(double linear);

/// Maps encoded [0, 1] to linear [0, 1] by the inverse of the sRGB transfer function. Clamps.
double linear_from_srgb(double encoded);

/// Returns an encoded value in [0, 1] as 8 bits, dithered by +-0.5 steps with an 8x8 Bayer matrix
/// (B. E. Bayer, "An optimum method for two-level rendition of continuous-tone pictures", ICC
/// 1973). The mean over a block of 8x8 pixels is right to 1/64 step. The values 0 and 1 are not
/// changed by the dither.
std::uint8_t quantise(double encoded, int x, int y);

/// Returns the threshold that quantise adds to 255 times the value before it drops the fraction.
double dither_threshold(int x, int y);

}  // namespace aerostat::image
