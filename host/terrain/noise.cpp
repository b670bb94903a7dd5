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

template <class Real>
struct Gradient {
  Real x, y;
};

// Returns the gradient of a lattice point. One table of cosines serves both components, because
// sin t = cos(t - pi / 2). The index is signed because compilers use gather instructions with
// signed indices only.
template <class Real>
AEROSTAT_INLINE Gradient<Real> gradient(const Real* table, std::uint32_t hash) {
  const auto angle = static_cast<std::int32_t>(hash >> (32 - kAngleBits));
  return {table[angle], table[(angle + 3 * kAngles / 4) & (kAngles - 1)]};
}

/// The gradients at the corners of the lattice cell that begins at ix, iy.
template <class Real>
struct Cell {
  Gradient<Real> g00, g10, g01, g11;

  AEROSTAT_INLINE Cell(const Real* table, std::uint32_t seed, std::int32_t ix, std::int32_t iy) {
    const auto jx = static_cast<std::int32_t>(static_cast<std::uint32_t>(ix) + 1u);
    const auto jy = static_cast<std::int32_t>(static_cast<std::uint32_t>(iy) + 1u);
    g00 = gradient(table, lattice_hash(seed, ix, iy));
    g10 = gradient(table, lattice_hash(seed, jx, iy));
    g01 = gradient(table, lattice_hash(seed, ix, jy));
    g11 = gradient(table, lattice_hash(seed, jx, jy));
  }
};

/// Limits a lattice coordinate to 2^30 either way, so that every number, and NaN too, has a cell.
/// In single precision, there are no numbers between lattice points from 2^23 on, and the noise
/// is 0 there.
template <class Real>
AEROSTAT_INLINE Real on_lattice(Real x) {
  constexpr Real kRim = 1 << 30;
  const Real above = x > -kRim ? x : -kRim;
  return above < kRim ? above : kRim;
}

// Truncates and then corrects the result to the floor, because SSE2 has no instruction for the
// floor.
template <class Real>
AEROSTAT_INLINE std::int32_t floor_of(Real x) {
  const auto i = static_cast<std::int32_t>(x);
  return i - static_cast<std::int32_t>(static_cast<Real>(i) > x);
}

/// Returns the noise at u, v in a cell.
template <class Real>
AEROSTAT_INLINE Sample<Real> blend(const Cell<Real>& cell, Real u, Real v) {
  const Real d00 = cell.g00.x * u + cell.g00.y * v;
  const Real d10 = cell.g10.x * (u - 1) + cell.g10.y * v;
  const Real d01 = cell.g01.x * u + cell.g01.y * (v - 1);
  const Real d11 = cell.g11.x * (u - 1) + cell.g11.y * (v - 1);
  const Real fu = u * u * u * (u * (u * 6 - 15) + 10);
  const Real fv = v * v * v * (v * (v * 6 - 15) + 10);
  const Real du = 30 * u * u * (u - 1) * (u - 1);
  const Real dv = 30 * v * v * (v - 1) * (v - 1);
  const Real low = lerp(d00, d10, fu);
  const Real high = lerp(d01, d11, fu);
  const Real gx = lerp(lerp(cell.g00.x, cell.g10.x, fu), lerp(cell.g01.x, cell.g11.x, fu), fv);
  const Real gy = lerp(lerp(cell.g00.y, cell.g10.y, fu), lerp(cell.g01.y, cell.g11.y, fu), fv);
  return {lerp(low, high, fv), gx + du * lerp(d10 - d00, d11 - d01, fv), gy + dv * (high - low)};
}

template <class Real>
AEROSTAT_INLINE Sample<Real> evaluate(const Real* table, Real any_x, Real any_y,
                                      std::uint32_t seed) {
  const Real x = on_lattice(any_x), y = on_lattice(any_y);
  const std::int32_t ix = floor_of(x), iy = floor_of(y);
  return blend(Cell<Real>(table, seed, ix, iy), x - static_cast<Real>(ix),
               y - static_cast<Real>(iy));
}

/// The number of points that are computed together. On a wide lattice, they share a cell, whose
/// corners are then found only once.
constexpr int kGroup = 16;

struct Group {
  std::array<std::int32_t, kGroup> ix, iy;
  std::array<float, kGroup> u, v;
  bool shares_a_cell;

  AEROSTAT_INLINE Group(const NoiseLayer& l, const float* px, const float* pz) {
    const auto lattice_x = [&l, px, pz](int k) AEROSTAT_INLINE_LAMBDA {
      return on_lattice(l.along_x * px[k] - l.along_z * pz[k] + l.offset_x);
    };
    const auto lattice_y = [&l, px, pz](int k) AEROSTAT_INLINE_LAMBDA {
      return on_lattice(l.along_z * px[k] + l.along_x * pz[k] + l.offset_y);
    };
    const std::int32_t x0 = floor_of(lattice_x(0)), y0 = floor_of(lattice_y(0));
    std::int32_t differing = 0;
    for (int k = 0; k < kGroup; ++k) {
      const float x = lattice_x(k), y = lattice_y(k);
      ix[k] = floor_of(x);
      iy[k] = floor_of(y);
      u[k] = x - static_cast<float>(ix[k]);
      v[k] = y - static_cast<float>(iy[k]);
      differing |= (ix[k] ^ x0) | (iy[k] ^ y0);
    }
    shares_a_cell = differing == 0;
  }
};

/// Calls `put(i, noise)` for each point. All results must be written to local objects. Otherwise
/// compilers could not see that no store changes the table or the points, and would not vectorise
/// the loops.
template <class Put>
AEROSTAT_INLINE void each_point(const NoiseLayer& l, const Points& points, const Put& put) {
  const float* table = cosines<float>();
  const int whole = points.count / kGroup * kGroup;
  for (int i = 0; i < whole; i += kGroup) {
    const Group group(l, &points.x[i], &points.z[i]);
    if (group.shares_a_cell) {
      const Cell<float> cell(table, l.seed, group.ix[0], group.iy[0]);
      for (int k = 0; k < kGroup; ++k) put(i + k, blend(cell, group.u[k], group.v[k]));
    } else {
      for (int k = 0; k < kGroup; ++k)
        put(i + k,
            blend(Cell<float>(table, l.seed, group.ix[k], group.iy[k]), group.u[k], group.v[k]));
    }
  }
  for (int i = whole; i < points.count; ++i) {
    const float x = l.along_x * points.x[i] - l.along_z * points.z[i] + l.offset_x;
    const float y = l.along_z * points.x[i] + l.along_x * points.z[i] + l.offset_y;
    put(i, evaluate(table, x, y, l.seed));
  }
}

AEROSTAT_INLINE void value_loop(const NoiseLayer& layer, const Points& points, Block& value) {
  const NoiseLayer l = layer;
  Block out;
  each_point(l, points, [&](int i, const Sample<float>& n) { out[i] = n.value; });
  std::copy_n(out.begin(), points.count, value.begin());
}

AEROSTAT_INLINE void slope_loop(const NoiseLayer& layer, const Points& points, Block& value,
                                Block& dx, Block& dz) {
  const NoiseLayer l = layer;
  Block out, out_dx, out_dz;
  each_point(l, points, [&](int i, const Sample<float>& n) {
    out[i] = n.value;
    out_dx[i] = l.along_x * n.dx + l.along_z * n.dy;
    out_dz[i] = l.along_x * n.dy - l.along_z * n.dx;
  });
  std::copy_n(out.begin(), points.count, value.begin());
  std::copy_n(out_dx.begin(), points.count, dx.begin());
  std::copy_n(out_dz.begin(), points.count, dz.begin());
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
  in_vectors([&]() AEROSTAT_INLINE_LAMBDA { value_loop(layer, points, value); });
}

void sample(const NoiseLayer& layer, const Points& points, Block& value, Block& dx, Block& dz) {
  in_vectors([&]() AEROSTAT_INLINE_LAMBDA { slope_loop(layer, points, value, dx, dz); });
}

}  // namespace aerostat::terrain
