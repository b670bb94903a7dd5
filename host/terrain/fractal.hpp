#pragma once

#include <algorithm>
#include <vector>

#include "noise.hpp"
#include "rules/noise.h"
#include "scene/land.hpp"

/// These functions sum noise layers after Musgrave (Ebert et al., "Texturing and Modeling",
/// chapter 16).
namespace aerostat::terrain {

/// One layer of a fractal sum.
struct Octave {
  NoiseLayer layer;
  float amplitude = 1.0f;
};

/// Returns the octaves of a fractal. The wavelengths are first_m, first_m / lacunarity and so on.
/// The amplitudes are 1, gain, gain^2 and so on.
std::vector<Octave> make_octaves(const scene::Fractal& fractal, double first_m, std::uint32_t seed);

/// Returns `count` octaves with lacunarity 2 and gain 1/2, for masks and distortions.
std::vector<Octave> make_soft_octaves(double first_m, std::uint32_t seed, int count = 2);

/// Returns the share of a wave that can be shown at a sample spacing.
inline float band_share(float wavelength_m, float spacing_m) {
  return rules::resolved(wavelength_m, std::max(spacing_m, 1e-6f));
}

/// Computes the sum of a_i n_i divided by the sum of a_i. The noise is scaled so that the result
/// fills [-1, 1].
void fbm(const std::vector<Octave>& octaves, const Points& points, Block& value);

/// Computes the fBm value and its derivatives by x and z, per metre.
void fbm(const std::vector<Octave>& octaves, const Points& points, Block& value, Block& dx,
         Block& dz);

/// Computes a ridged multifractal, scaled to about [0, 1]. Each octave is s = (offset - |n|)^2.
/// Its weight is w = clamp(2 s w, 0, 1) of the octave before it, so that heights are rough and
/// valleys smooth.
void ridged(const std::vector<Octave>& octaves, float offset, const Points& points, Block& value);

/// The derivatives of the moved points by the original points.
struct Jacobian {
  Block x_by_x, x_by_z, z_by_x, z_by_z;
};

/// Moves points by amplitude_m times two independent fractals, one in x and one in z.
class Distortion {
 public:
  Distortion() = default;
  Distortion(double amplitude_m, double wavelength_m, std::uint32_t seed, int octaves = 2);

  void apply(Points& points) const;
  void apply(Points& points, Jacobian& jacobian) const;

 private:
  float amplitude_m_ = 0.0f;
  std::vector<Octave> x_;
  std::vector<Octave> z_;
};

}  // namespace aerostat::terrain
