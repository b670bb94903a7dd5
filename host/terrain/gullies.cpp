#include "gullies.hpp"

#include <algorithm>
#include <cmath>

#include "core/simd.hpp"
#include "fractal.hpp"
#include "noise.hpp"

namespace aerostat::terrain {
namespace {

/// The sum of the waves around each point: cosine and sine.
struct Waves {
  Block cosine, sine;
};

/// The slope that an octave finds at each point: the direction across it, the depth of gullies
/// there, and the share of that depth that can be shown.
struct Fall {
  Block side_x, side_z, depth, share;
};

/// The lattice of one octave's waves.
struct Wave {
  float scale;  // squares of the lattice per metre
  float shift;
  std::uint32_t seed;
};

/// Computes cosine and sine of a fraction of a turn in [-1/2, 1/2]. The error is below 2e-3, and
/// the functions are continuous at the ends.
AEROSTAT_INLINE void wave_of(float turn, float& cosine, float& sine) {
  // The sine of each half turn is approximated by a parabola that is bent towards it.
  const float s = 8.0f * turn * (1.0f - 2.0f * std::fabs(turn));
  sine = s * (0.775f + 0.225f * std::fabs(s));
  float quarter = turn + 0.25f;
  quarter -= static_cast<float>(static_cast<std::int32_t>(quarter + 8.5f) - 8);
  const float c = 8.0f * quarter * (1.0f - 2.0f * std::fabs(quarter));
  cosine = c * (0.775f + 0.225f * std::fabs(c));
}

/// A point in a square of the lattice, and the direction across its wave.
struct Square {
  std::uint32_t seed;
  std::int32_t ix, iz;
  float u, v, side_x, side_z;
};

/// Adds the wave around the random point of the square that lies i, j squares farther on.
template <int i, int j>
AEROSTAT_INLINE void add_wave(const Square& at, float& cosines, float& sines) {
  const std::uint32_t hash = lattice_hash(at.seed, at.ix + i, at.iz + j);
  const float px = static_cast<float>(static_cast<std::int32_t>(hash >> 20)) * (0.6f / 4096.0f) +
                   (0.2f + static_cast<float>(i));
  const float pz =
      static_cast<float>(static_cast<std::int32_t>((hash >> 8) & 4095u)) * (0.6f / 4096.0f) +
      (0.2f + static_cast<float>(j));
  const float du = at.u - px, dv = at.v - pz;
  const float inside = 1.21f - (du * du + dv * dv);
  const float near = 0.5f * (inside + std::fabs(inside));  // 0 beyond the reach, without a branch
  const float turn = du * at.side_x + dv * at.side_z;
  float cosine, sine;
  wave_of(turn - static_cast<float>(static_cast<std::int32_t>(turn + 8.5f) - 8), cosine, sine);
  const float weight = near * near * near;
  cosines += weight * cosine;
  sines += weight * sine;
}

AEROSTAT_INLINE void wave_loop(const Wave& wave, const Points& points, const Fall& fall,
                               Waves& out) {
  const Wave w = wave;
  const int count = points.count;
  Waves sum;
  for (int k = 0; k < count; ++k) {
    const float x = points.x[k] * w.scale + w.shift;
    const float z = points.z[k] * w.scale - w.shift;
    auto ix = static_cast<std::int32_t>(x);
    auto iz = static_cast<std::int32_t>(z);
    ix -= static_cast<std::int32_t>(static_cast<float>(ix) > x);
    iz -= static_cast<std::int32_t>(static_cast<float>(iz) > z);
    const float u = x - static_cast<float>(ix), v = z - static_cast<float>(iz);
    float cosines = 0.0f, sines = 0.0f;
    // The calls are written out because compilers do not vectorise a loop within this one.
    const Square at{w.seed, ix, iz, u, v, fall.side_x[k], fall.side_z[k]};
    add_wave<-1, -1>(at, cosines, sines);
    add_wave<0, -1>(at, cosines, sines);
    add_wave<1, -1>(at, cosines, sines);
    add_wave<-1, 0>(at, cosines, sines);
    add_wave<0, 0>(at, cosines, sines);
    add_wave<1, 0>(at, cosines, sines);
    add_wave<-1, 1>(at, cosines, sines);
    add_wave<0, 1>(at, cosines, sines);
    add_wave<1, 1>(at, cosines, sines);
    sum.cosine[k] = cosines;
    sum.sine[k] = sines;
  }
  std::copy_n(sum.cosine.begin(), points.count, out.cosine.begin());
  std::copy_n(sum.sine.begin(), points.count, out.sine.begin());
}

/// The height of a wave at a phase, from 1 on the crest to -1 on the floor, and its slope by the
/// phase in radians.
struct Profile {
  float height, slope;
};

/// Returns the profile of a rib from the cosine and sine of the phase. `round` > 0 rounds off the
/// crest.
AEROSTAT_INLINE Profile ribbed(float cosine, float sine, float round) {
  // The term |sin(phase / 2)| gives a crest like a roof and a floor like a trough.
  const float half = std::sqrt(std::max(0.5f * (1.0f - cosine), 0.0f) + round);
  return {1.0f - 2.0f * half, -0.5f * sine / half};
}

/// Finds the slope that gullies follow. Returns false if no gully can be shown.
AEROSTAT_INLINE bool find_fall(const Points& points, const Block& strength, const Slopes& ground,
                               float width, float relative_depth, Fall& fall) {
  int some = 0;
  for (int i = 0; i < points.count; ++i) {
    fall.share[i] = band_share(width, points.spacing[i]) * strength[i];
    some |= static_cast<int>(fall.share[i] > 0.0f);
    const float steep = std::sqrt(ground.dx[i] * ground.dx[i] + ground.dz[i] * ground.dz[i]);
    const float inverse = 1.0f / std::max(steep, 1e-6f);
    fall.side_x[i] = -ground.dz[i] * inverse;
    fall.side_z[i] = ground.dx[i] * inverse;
    // Gentle ground has no gullies. The depth on walls is limited.
    fall.depth[i] = 0.5f * relative_depth * width * std::min(steep * steep / (steep + 0.35f), 1.1f);
  }
  return some != 0;
}

AEROSTAT_INLINE void cut(const Points& points, const Fall& fall, const Waves& waves, float width,
                         Slopes& ground) {
  constexpr float kTwoPi = 6.28318531f;
  for (int i = 0; i < points.count; ++i) {
    const float size = std::sqrt(waves.cosine[i] * waves.cosine[i] + waves.sine[i] * waves.sine[i]);
    // Where waves cancel out, neither of them fits, and the slope is left even.
    const float kept = 1.0f / std::max(size, 0.25f);
    const float full = std::min(4.0f * size, 1.0f);
    const float round = 0.02f + 0.2f * points.spacing[i] / width;
    const Profile profile = ribbed(waves.cosine[i] * kept, waves.sine[i] * kept, round);
    const float metres = fall.share[i] * fall.depth[i] * full;
    const float slope = metres * profile.slope * kTwoPi / width;
    ground.height[i] += metres * profile.height;
    ground.dx[i] += slope * fall.side_x[i];
    ground.dz[i] += slope * fall.side_z[i];
  }
}

}  // namespace

Gullies::Gullies(double widest_m, int octaves, float depth, std::uint32_t seed)
    : widest_m_(widest_m), octaves_(octaves), depth_(depth), seed_(seed) {}

void Gullies::add(const Points& points, const Block& strength, Slopes& ground) const {
  double width_m = widest_m_;
  for (int octave = 0; octave < octaves_; ++octave, width_m *= 0.5) {
    const auto width = static_cast<float>(width_m);
    // There is one wave in every square.
    const Wave wave{1.0f / width, 0.31f * static_cast<float>(octave),
                    seed_ + 0x9E3779B9u * static_cast<std::uint32_t>(octave)};
    in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
      Fall fall;
      if (!find_fall(points, strength, ground, width, depth_, fall)) return;
      Waves waves;
      wave_loop(wave, points, fall, waves);
      cut(points, fall, waves, width, ground);
    });
  }
}

}  // namespace aerostat::terrain
