#include "noise.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace aerostat::terrain {
namespace {

constexpr int kAngles = 1 << kAngleBits;

template <class Real>
std::array<Real, kAngles> make_cosines() {
  std::array<Real, kAngles> table{};
  for (int i = 0; i < kAngles; ++i)
    table[i] = static_cast<Real>(std::cos(2.0 * std::numbers::pi * i / kAngles));
  return table;
}

template <class Real>
const std::array<Real, kAngles> kCosines = make_cosines<Real>();

template <class Real>
struct Sample {
  Real value, dx, dy;
};

template <class Real>
Real lerp(Real a, Real b, Real t) {
  return a + t * (b - a);
}

// sin t = cos(t - pi / 2): one table serves both.
template <class Real>
struct Corner {
  Real gx, gy, dot;

  Corner(const Real* cosines, std::uint32_t hash, Real u, Real v) {
    const std::uint32_t angle = hash >> (32 - kAngleBits);
    gx = cosines[angle];
    gy = cosines[(angle + 3u * kAngles / 4u) & (kAngles - 1u)];
    dot = gx * u + gy * v;
  }
};

template <class Real>
Sample<Real> evaluate(const Real* cosines, Real x, Real y, std::uint32_t seed) {
  // Truncation corrected to the floor, because SSE2 has no instruction for the latter.
  auto ix = static_cast<std::int32_t>(x);
  auto iy = static_cast<std::int32_t>(y);
  ix -= static_cast<Real>(ix) > x ? 1 : 0;
  iy -= static_cast<Real>(iy) > y ? 1 : 0;
  const Real u = x - static_cast<Real>(ix);
  const Real v = y - static_cast<Real>(iy);
  const auto jx = static_cast<std::int32_t>(static_cast<std::uint32_t>(ix) + 1u);
  const auto jy = static_cast<std::int32_t>(static_cast<std::uint32_t>(iy) + 1u);

  const Corner<Real> c00(cosines, lattice_hash(seed, ix, iy), u, v);
  const Corner<Real> c10(cosines, lattice_hash(seed, jx, iy), u - 1, v);
  const Corner<Real> c01(cosines, lattice_hash(seed, ix, jy), u, v - 1);
  const Corner<Real> c11(cosines, lattice_hash(seed, jx, jy), u - 1, v - 1);

  const Real fu = u * u * u * (u * (u * 6 - 15) + 10);
  const Real fv = v * v * v * (v * (v * 6 - 15) + 10);
  const Real du = 30 * u * u * (u - 1) * (u - 1);
  const Real dv = 30 * v * v * (v - 1) * (v - 1);
  const Real low = lerp(c00.dot, c10.dot, fu);
  const Real high = lerp(c01.dot, c11.dot, fu);
  const Real gx = lerp(lerp(c00.gx, c10.gx, fu), lerp(c01.gx, c11.gx, fu), fv);
  const Real gy = lerp(lerp(c00.gy, c10.gy, fu), lerp(c01.gy, c11.gy, fu), fv);
  return {lerp(low, high, fv), gx + du * lerp(c10.dot - c00.dot, c11.dot - c01.dot, fv),
          gy + dv * (high - low)};
}

struct LatticePoint {
  float x, y;
};

LatticePoint lattice_point(const NoiseLayer& l, float x, float z) {
  return {l.along_x * x - l.along_z * z + l.offset_x, l.along_z * x + l.along_x * z + l.offset_y};
}

}  // namespace

double perlin(double x, double y, std::uint32_t seed) {
  return evaluate(kCosines<double>.data(), x, y, seed).value;
}

NoiseSample perlin_with_slope(double x, double y, std::uint32_t seed) {
  const Sample<double> n = evaluate(kCosines<double>.data(), x, y, seed);
  return {n.value, n.dx, n.dy};
}

NoiseLayer make_layer(double wavelength_m, std::uint32_t seed, std::uint32_t index) {
  const auto word = [&](int which) { return lattice_hash(seed, static_cast<int>(index), which); };
  const double angle = 2.0 * std::numbers::pi * word(1) / 4294967296.0;
  NoiseLayer layer;
  layer.along_x = static_cast<float>(std::cos(angle) / wavelength_m);
  layer.along_z = static_cast<float>(std::sin(angle) / wavelength_m);
  layer.offset_x = static_cast<float>(word(2) >> 16) / 512.0f;
  layer.offset_y = static_cast<float>(word(3) >> 16) / 512.0f;
  layer.wavelength_m = static_cast<float>(wavelength_m);
  layer.seed = word(4);
  return layer;
}

void sample(const NoiseLayer& layer, const Points& points, Block& value) {
  const NoiseLayer l = layer;
  for (int i = 0; i < points.count; ++i) {
    const LatticePoint p = lattice_point(l, points.x[i], points.z[i]);
    value[i] = evaluate(kCosines<float>.data(), p.x, p.y, l.seed).value;
  }
}

void sample(const NoiseLayer& layer, const Points& points, Block& value, Block& dx, Block& dz) {
  const NoiseLayer l = layer;
  for (int i = 0; i < points.count; ++i) {
    const LatticePoint p = lattice_point(l, points.x[i], points.z[i]);
    const Sample<float> n = evaluate(kCosines<float>.data(), p.x, p.y, l.seed);
    value[i] = n.value;
    dx[i] = l.along_x * n.dx + l.along_z * n.dy;
    dz[i] = l.along_x * n.dy - l.along_z * n.dx;
  }
}

}  // namespace aerostat::terrain
