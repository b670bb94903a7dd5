#include "noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/simd.hpp"

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
const Real* cosines() {
  static const std::array<Real, kAngles> table = make_cosines<Real>();
  return table.data();
}

template <class Real>
struct Sample {
  Real value, dx, dy;
};

template <class Real>
AEROSTAT_INLINE Real lerp(Real a, Real b, Real t) {
  return a + t * (b - a);
}

// sin t = cos(t - pi / 2): one table serves both. The index is signed because compilers gather
// with signed indices only.
template <class Real>
struct Corner {
  Real gx, gy, dot;

  AEROSTAT_INLINE Corner(const Real* table, std::uint32_t hash, Real u, Real v) {
    const auto angle = static_cast<std::int32_t>(hash >> (32 - kAngleBits));
    gx = table[angle];
    gy = table[(angle + 3 * kAngles / 4) & (kAngles - 1)];
    dot = gx * u + gy * v;
  }
};

template <class Real>
AEROSTAT_INLINE Sample<Real> evaluate(const Real* table, Real x, Real y, std::uint32_t seed) {
  // Truncation corrected to the floor, because SSE2 has no instruction for the latter.
  auto ix = static_cast<std::int32_t>(x);
  auto iy = static_cast<std::int32_t>(y);
  ix -= static_cast<std::int32_t>(static_cast<Real>(ix) > x);
  iy -= static_cast<std::int32_t>(static_cast<Real>(iy) > y);
  const Real u = x - static_cast<Real>(ix);
  const Real v = y - static_cast<Real>(iy);
  const auto jx = static_cast<std::int32_t>(static_cast<std::uint32_t>(ix) + 1u);
  const auto jy = static_cast<std::int32_t>(static_cast<std::uint32_t>(iy) + 1u);

  const Corner<Real> c00(table, lattice_hash(seed, ix, iy), u, v);
  const Corner<Real> c10(table, lattice_hash(seed, jx, iy), u - 1, v);
  const Corner<Real> c01(table, lattice_hash(seed, ix, jy), u, v - 1);
  const Corner<Real> c11(table, lattice_hash(seed, jx, jy), u - 1, v - 1);

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

// Everything that is written is local: otherwise it might be the table or the points, and no
// compiler would vectorise the loops.
AEROSTAT_INLINE void value_loop(const NoiseLayer& layer, const Points& points, Block& value) {
  const NoiseLayer l = layer;
  const float* table = cosines<float>();
  const int count = points.count;
  Block out;
  for (int i = 0; i < count; ++i) {
    const float x = l.along_x * points.x[i] - l.along_z * points.z[i] + l.offset_x;
    const float y = l.along_z * points.x[i] + l.along_x * points.z[i] + l.offset_y;
    out[i] = evaluate(table, x, y, l.seed).value;
  }
  std::copy_n(out.begin(), count, value.begin());
}

AEROSTAT_INLINE void slope_loop(const NoiseLayer& layer, const Points& points, Block& value,
                                Block& dx, Block& dz) {
  const NoiseLayer l = layer;
  const float* table = cosines<float>();
  const int count = points.count;
  Block out, out_dx, out_dz;
  for (int i = 0; i < count; ++i) {
    const float x = l.along_x * points.x[i] - l.along_z * points.z[i] + l.offset_x;
    const float y = l.along_z * points.x[i] + l.along_x * points.z[i] + l.offset_y;
    const Sample<float> n = evaluate(table, x, y, l.seed);
    out[i] = n.value;
    out_dx[i] = l.along_x * n.dx + l.along_z * n.dy;
    out_dz[i] = l.along_x * n.dy - l.along_z * n.dx;
  }
  std::copy_n(out.begin(), count, value.begin());
  std::copy_n(out_dx.begin(), count, dx.begin());
  std::copy_n(out_dz.begin(), count, dz.begin());
}

struct Loops {
  void (*value)(const NoiseLayer&, const Points&, Block&);
  void (*slope)(const NoiseLayer&, const Points&, Block&, Block&, Block&);
};

void value_plain(const NoiseLayer& l, const Points& p, Block& v) {
  value_loop(l, p, v);
}

void slope_plain(const NoiseLayer& l, const Points& p, Block& v, Block& dx, Block& dz) {
  slope_loop(l, p, v, dx, dz);
}

AEROSTAT_FOR_AVX2 void value_avx2(const NoiseLayer& l, const Points& p, Block& v) {
  value_loop(l, p, v);
}

AEROSTAT_FOR_AVX2 void slope_avx2(const NoiseLayer& l, const Points& p, Block& v, Block& dx,
                                  Block& dz) {
  slope_loop(l, p, v, dx, dz);
}

AEROSTAT_FOR_AVX512 void value_avx512(const NoiseLayer& l, const Points& p, Block& v) {
  value_loop(l, p, v);
}

AEROSTAT_FOR_AVX512 void slope_avx512(const NoiseLayer& l, const Points& p, Block& v, Block& dx,
                                      Block& dz) {
  slope_loop(l, p, v, dx, dz);
}

const Loops& loops() {
  static const Loops chosen = widest(Loops{value_plain, slope_plain}, Loops{value_avx2, slope_avx2},
                                     Loops{value_avx512, slope_avx512});
  return chosen;
}

}  // namespace

double perlin(double x, double y, std::uint32_t seed) {
  return evaluate(cosines<double>(), x, y, seed).value;
}

NoiseSample perlin_with_slope(double x, double y, std::uint32_t seed) {
  const Sample<double> n = evaluate(cosines<double>(), x, y, seed);
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
  loops().value(layer, points, value);
}

void sample(const NoiseLayer& layer, const Points& points, Block& value, Block& dx, Block& dz) {
  loops().slope(layer, points, value, dx, dz);
}

}  // namespace aerostat::terrain
