#pragma once

#include <cstdint>
#include <vector>

#include "image/film.hpp"

namespace aerostat::image {

/// 8-bit RGB, row 0 at the top.
struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Stops that suit a picture: the mean logarithm of its luminance, without the darkest fifth and
/// the brightest twentieth of the pixels, goes to a grey of 0.25, or up to two stops darker where
/// that keeps the brightest hundredth below white, so that snow does not clip, or up to half a stop
/// brighter where that hundredth is far from it. Below 100 cd/m^2 the grey falls as views look to
/// an eye, by two stops at 1 cd/m^2 and five by night: radiance 1 counts as 26620 cd/m^2, as under
/// a sun of irradiance 5. 0 for a picture without light.
double automatic_exposure_ev(const Film& film);

/// How a film becomes a picture.
struct Look {
  double exposure_ev = 0.0;       // stops
  glm::dmat3 white_balance{1.0};  // of linear Rec. 709
  double vignette = 0.0;          // share of the light lost in the corners, 0 to below 1
};

/// Vignette, exposure (2^ev), white balance, a filmic tone curve, the sRGB transfer function, and
/// ordered dither against banding; deterministic. A part of a picture becomes the same pixels as in
/// the whole.
Pixels develop(const Film& film, const Look& look);
Pixels develop(const Film& film, double exposure_ev);

/// Share of the light that is left at a distance from the picture's middle (1 in the corners):
/// cos^4 of an angle whose tangent grows with the distance, so that `lost` is lost in the corners.
double vignette_share(double distance, double lost);

/// Whether encode_png can take so many pixels: the encoder counts in int. Up to 16384 x 16384 it
/// can.
bool png_can_hold(int width, int height);

/// The bytes of a PNG file. Throws Error{internal} if the encoder fails or png_can_hold is false.
std::vector<std::uint8_t> encode_png(const Pixels& pixels);

/// The bytes of an OpenEXR file: float channels R G B A, Z, N.X N.Y N.Z, uint channel id,
/// compressed without loss (ZIP). The display window is the whole picture, the data window the part
/// of it that the film shows. Layers that the film does not have are left out. Throws
/// Error{internal} if a layer's length is wrong or the encoder fails.
std::vector<std::uint8_t> encode_exr(const Film& film);

}  // namespace aerostat::image
