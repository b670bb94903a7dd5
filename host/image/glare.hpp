#pragma once

#include <cstddef>
#include <vector>

#include "image/film.hpp"
#include "image/write.hpp"

/// Glare: light that a lens and an eye scatter around what is far brighter than white.
namespace aerostat::image {

/// The exposed value from which on light makes glare: that which the tone curve shows as white.
inline constexpr double kGlareFrom = 6.0;

/// The share of that light which is scattered at a glare of 1. Chosen by eye.
inline constexpr double kMostGlare = 0.04;

/// The glare of a picture. Of a radiance whose largest component is p when it is exposed, the share
///   glare kMostGlare max(0, 1 - kGlareFrom / p)
/// is taken away and spread by a sum of Gaussians around it, whose widths are shares of the
/// picture's height, so that it looks the same at every size. What falls beside the picture is
/// lost. The light is gathered in a grid of at most 216 rows, whatever the size.
class Glare {
 public:
  /// Makes the glare of a picture of this size without light.
  Glare(const glm::ivec2& whole, const Development& development);

  /// Gathers the light of a film that is a part of the picture. A picture may be given in runs of
  /// whole rows, from the top to the bottom, and the result has the same bits.
  void add(const Film& film);

  /// Spreads what was gathered.
  void spread();

  /// Returns whether there is any glare.
  bool is_there() const { return is_there_; }

  /// Writes the radiance with glare of `count` pixels of a row of a film to `light`, three floats a
  /// pixel, from x on.
  void apply(const Film& film, int x, int y, int count, float* light) const;

 private:
  vec3 at(double column, double row) const;
  float lost_share(const vec3& radiance) const;
  void gather_row(const Film& film, int y);

  glm::ivec2 whole_, size_;
  float share_, exposure_;
  bool is_there_ = false;
  /// Light of each cell: the sum of its pixels, and then what has been spread, a pixel.
  std::vector<dvec3> gathered_;
  std::vector<vec3> spread_;
};

}  // namespace aerostat::image
