#pragma once

#include <cstdint>

#include "points.hpp"

/// Two-dimensional gradient noise after Perlin ("An image synthesizer", 1985; "Improving noise",
/// 2002), with unit gradients of a random angle.
///
/// With x_int = floor(x), y_int = floor(y), u = x - x_int, v = y - y_int, the gradient g of each
/// of the four lattice corners and the offset d from that corner:
///
///     n = lerp(lerp(g00.d00, g10.d10, fade(u)), lerp(g01.d01, g11.d11, fade(u)), fade(v))
///     lerp(a, b, t) = a + t (b - a)        fade(t) = 6 t^5 - 15 t^4 + 10 t^3
///     g(ix, iy) = (cos t, sin t)           t = 2 pi (lattice_hash(seed, ix, iy) >> 20) / 4096
///
/// It is 0 at lattice points, has a continuous second derivative, and |n| <= sqrt(1/2).
namespace aerostat::terrain {

/// Bits of the hash that become the gradient's angle.
inline constexpr int kAngleBits = 12;

/// Bound of |n|.
inline constexpr double kNoiseBound = 0.70710678118654752;

/// Hash of a lattice point, in 32-bit arithmetic that wraps around (the same in OpenCL C `uint`).
/// Signed coordinates are taken modulo 2^32. Multipliers of the finalizer: C. Wellons, lowbias32.
constexpr std::uint32_t lattice_hash(std::uint32_t seed, std::int32_t ix, std::int32_t iy) {
  std::uint32_t h = (static_cast<std::uint32_t>(ix) * 0x9E3779B1u) ^ (seed * 0x85EBCA6Bu);
  h ^= h >> 16;
  h *= 0x7FEB352Du;
  h ^= h >> 15;
  h ^= static_cast<std::uint32_t>(iy) * 0xC2B2AE35u;
  h ^= h >> 16;
  h *= 0x7FEB352Du;
  h ^= h >> 15;
  h *= 0x846CA68Bu;
  return h;
}

/// A noise value and its exact derivatives.
struct NoiseSample {
  double value = 0.0;
  double dx = 0.0;
  double dy = 0.0;
};

/// Noise at a point of the lattice's plane; beyond 2^30 that of the rim.
double perlin(double x, double y, std::uint32_t seed);

/// The same with derivatives.
NoiseSample perlin_with_slope(double x, double y, std::uint32_t seed);

/// A layer of noise laid over the ground: lattice coordinates are
/// (along_x * x - along_z * z + offset_x, along_z * x + along_x * z + offset_y),
/// a rotation, a scaling by 1 / wavelength_m and a shift.
struct NoiseLayer {
  float along_x = 1.0f;
  float along_z = 0.0f;
  float offset_x = 0.0f;
  float offset_y = 0.0f;
  float wavelength_m = 1.0f;
  std::uint32_t seed = 0;
};

/// A layer whose rotation and shift come from `seed` and `index`, so that no two layers share
/// their lattice.
NoiseLayer make_layer(double wavelength_m, std::uint32_t seed, std::uint32_t index);

/// Noise of a layer at each point, in single precision.
void sample(const NoiseLayer& layer, const Points& points, Block& value);

/// The same with derivatives by x and z, per metre.
void sample(const NoiseLayer& layer, const Points& points, Block& value, Block& dx, Block& dz);

}  // namespace aerostat::terrain
