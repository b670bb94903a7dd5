#pragma once

#include <cstdint>

#include "points.hpp"
#include "rules/hash.h"

/// These functions compute two-dimensional gradient noise after Perlin ("An image synthesizer",
/// 1985; "Improving noise", 2002), with unit gradients of a random angle.
///
/// Let u = x - floor(x) and v = y - floor(y). Let g be the gradient at each of the four lattice
/// corners, and d the offset from that corner. The noise is
///
///     n = lerp(lerp(g00.d00, g10.d10, fade(u)), lerp(g01.d01, g11.d11, fade(u)), fade(v))
///     lerp(a, b, t) = a + t (b - a)        fade(t) = 6 t^5 - 15 t^4 + 10 t^3
///     g(ix, iy) = (cos t, sin t)           t = 2 pi (lattice_hash(seed, ix, iy) >> 20) / 4096
///
/// The noise is 0 at lattice points and has a continuous second derivative. Its size |n| is at
/// most sqrt(1/2).
namespace aerostat::terrain {

/// The number of bits of the hash that give the angle of a gradient.
inline constexpr int kAngleBits = 12;

/// The largest possible |n|.
inline constexpr double kNoiseBound = 0.70710678118654752;

using rules::lattice_hash;

/// A noise value and its exact derivatives.
struct NoiseSample {
  double value = 0.0;
  double dx = 0.0;
  double dy = 0.0;
};

/// Returns the noise at a point of the lattice's plane. Coordinates beyond 2^30 count as 2^30.
double perlin(double x, double y, std::uint32_t seed);

/// Returns the noise at a point of the lattice's plane with its derivatives.
NoiseSample perlin_with_slope(double x, double y, std::uint32_t seed);

/// A layer of noise laid over the ground. A rotation, a scaling by 1 / wavelength_m and a shift
/// give the lattice coordinates:
///   (along_x * x - along_z * z + offset_x, along_z * x + along_x * z + offset_y)
struct NoiseLayer {
  float along_x = 1.0f;
  float along_z = 0.0f;
  float offset_x = 0.0f;
  float offset_y = 0.0f;
  float wavelength_m = 1.0f;
  std::uint32_t seed = 0;
};

/// Returns a layer whose rotation and shift come from `seed` and `index`, so that no two layers
/// share their lattice.
NoiseLayer make_layer(double wavelength_m, std::uint32_t seed, std::uint32_t index);

/// Computes the noise of a layer at each point, in single precision.
void sample(const NoiseLayer& layer, const Points& points, Block& value);

/// Computes the noise of a layer at each point with its derivatives by x and z, per metre.
void sample(const NoiseLayer& layer, const Points& points, Block& value, Block& dx, Block& dz);

}  // namespace aerostat::terrain
