#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/film.hpp"

namespace aerostat::image {

/// A picture of 8-bit RGB with row 0 at the top.
struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Returns the stops that suit a picture, or 0 for a picture without light. The mean logarithm of
/// its luminance, without the darkest fifth and the brightest twentieth of the pixels, becomes a
/// grey of 0.25. The picture is up to two stops darker where that keeps the brightest hundredth
/// below white, so that snow does not clip. It is up to half a stop brighter where that hundredth
/// is far below white. Below 100 cd/m^2 the grey falls as views look darker to an eye, by two
/// stops at 1 cd/m^2 and five by night. Radiance 1 counts as 26620 cd/m^2, as under a sun of
/// irradiance 5.
double automatic_exposure_ev(const Film& film);

/// The settings that turn a film into a picture.
struct Development {
  double exposure_ev = 0.0;       // exposure in stops
  glm::dmat3 white_balance{1.0};  // matrix for linear Rec. 709
  double vignette = 0.0;          // share of the light lost in the corners, 0 to below 1
  double glare = 0.0;             // strength of the glare (image/glare.hpp), 0 to 1
};

class Glare;

/// Turns a film into a picture. Applies the glare, the vignette, the exposure (2^ev), the white
/// balance, a filmic tone curve, the sRGB transfer function and ordered dither against banding. The
/// result is deterministic. A part of a picture has the same pixels as the whole but for the glare,
/// which is that of the part's own light.
Pixels develop(const Film& film, const Development& development);
Pixels develop(const Film& film, double exposure_ev);

/// Does the same with the glare of the whole picture, which has been spread.
Pixels develop(const Film& film, const Development& development, const Glare& glare);

/// Returns the share of the light that is left at a distance from the picture's middle, which is
/// 1 in the corners. The share is cos^4 of an angle whose tangent is proportional to the
/// distance. In the corners, the share `lost` is lost.
double vignette_share(double distance, double lost);

/// Returns whether encode_png can hold a picture of this size. The limit exists because the
/// encoder counts in int. Pictures up to 16384 x 16384 pixels fit.
bool png_can_hold(int width, int height);

/// Returns the bytes of a PNG file. Throws Error{internal} if the encoder fails or if
/// png_can_hold returns false.
std::vector<std::uint8_t> encode_png(const Pixels& pixels);

/// Returns the bytes of a PNG file with opacity: four bytes a pixel, rows from the top on. Throws
/// Error{internal} if the encoder fails or the number of bytes does not fit the size.
std::vector<std::uint8_t> encode_png(std::span<const std::uint8_t> rgba, int width, int height);

/// Returns the bytes of an OpenEXR file, compressed without loss (ZIP). It has float channels R G
/// B A, Z, N.X N.Y N.Z and albedo.R albedo.G albedo.B, and uint channels id and samples. The
/// display window is the whole picture. The data window is the part of it that the film shows.
/// Layers that the film does not have are left out. A mark (image/mark.hpp) that is not empty is
/// kept in the file. Throws Error{internal} if a layer's length is
/// wrong or if the encoder fails.
std::vector<std::uint8_t> encode_exr(const Film& film, const std::string& mark = {});

}  // namespace aerostat::image
