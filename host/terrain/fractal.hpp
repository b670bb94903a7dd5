#pragma once

#include <algorithm>
#include <vector>

#include "noise.hpp"
#include "scene/scene.hpp"

/// Sums of noise layers after Musgrave (Ebert et al., "Texturing and Modeling", chapter 16).
namespace aerostat::terrain {

/// A layer of a fractal sum.
struct Octave {
  NoiseLayer layer;
  float amplitude = 1.0f;
};

/// The octaves of a fractal: wavelengths first_m, first_m / lacunarity, ...; amplitudes 1, gain,
/// gain^2, ...
std::vector<Octave> make_octaves(const scene::Fractal& fractal, double first_m, std::uint32_t seed);

/// Layers of two octaves with lacunarity 2 and gain 1/2: for masks and distortions.
std::vector<Octave> make_soft_octaves(double first_m, std::uint32_t seed, int count = 2);

/// How much of a wavelength can be shown at a sample spacing: 1 from four samples per wave, 0 up
/// to two (Nyquist's limit).
inline float band_share(float wavelength_m, float spacing_m) {
  return std::clamp(0.5f * wavelength_m / std::max(spacing_m, 1e-6f) - 1.0f, 0.0f, 1.0f);
}

/// sum a_i n_i / sum a_i, within [-1, 1] (the noise is scaled up to fill it).
void fbm(const std::vector<Octave>& octaves, const Points& points, Block& value);

/// The same with derivatives by x and z, per metre.
void fbm(const std::vector<Octave>& octaves, const Points& points, Block& value, Block& dx,
         Block& dz);

/// Ridged multifractal: each octave is s = (offset - |n|)^2, weighted by the octaves before it,
/// clamp(2 s w, 0, 1), so that heights are rough and valleys smooth. Scaled to about [0, 1].
void ridged(const std::vector<Octave>& octaves, float offset, const Points& points, Block& value);

/// Derivatives of where points are moved to by where they were.
struct Jacobian {
  Block x_by_x, x_by_z, z_by_x, z_by_z;
};

/// Moves the points by amplitude_m times two independent fractals, in x and in z.
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
