#include <algorithm>
#include <cmath>
#include <numbers>

#include "blend.hpp"
#include "core/smooth_step.hpp"
#include "fractal.hpp"
#include "relief.hpp"

namespace aerostat::terrain {
namespace {

// The tangent of 33 degrees, at which dry sand comes to rest. A slip face lies at that angle.
constexpr float kReposeTangent = 0.649f;

/// The contribution of one set of dunes: a height, and how far a point lies on a slip face (0 to
/// 1).
struct DuneBlock {
  Block height;
  Block slip;
};

/// One set of transverse dunes. The phase grows by 1 from crest to crest along the wind and is
/// bent by noise. The width of the slip face follows from the local height and the local gradient
/// of the phase, so that its slope is the angle of repose wherever the crest runs.
class DuneSet {
 public:
  DuneSet(const scene::Dunes& dunes, double scale, double turn_deg, std::uint32_t seed);

  void evaluate(const Points& points, DuneBlock& out) const;

 private:
  float wavelength_m_;
  float height_m_;
  float wind_x_;
  float wind_z_;
  NoiseLayer spread_;     // varies the distance between crests
  NoiseLayer sinuosity_;  // bends the crests
  std::vector<Octave> size_;
};

DuneSet::DuneSet(const scene::Dunes& dunes, double scale, double turn_deg, std::uint32_t seed)
    : wavelength_m_(static_cast<float>(dunes.wavelength_m * scale)),
      height_m_(static_cast<float>(dunes.height_m * scale)),
      spread_(make_layer(7.0 * wavelength_m_, seed, 0)),
      sinuosity_(make_layer(2.3 * wavelength_m_, seed, 1)),
      size_(make_soft_octaves(3.5 * wavelength_m_, seed ^ 0x2545F491u, 2)) {
  const double azimuth = (dunes.wind_deg + turn_deg) * std::numbers::pi / 180.0;
  wind_x_ = static_cast<float>(std::sin(azimuth));
  wind_z_ = static_cast<float>(-std::cos(azimuth));
}

/// Returns the height of a windward side at share t of its length. The side is concave at the
/// foot and convex below the crest. It continues in a straight line beyond the crest.
float windward(float t) {
  constexpr float kCurved = 0.65f;
  if (t > 1.0f) return 1.0f + (1.0f - kCurved) * (t - 1.0f);
  return mix(t, smooth_unit_step(t), kCurved);
}

/// The share of a slip face, at its foot, that curves into the plain.
constexpr float kFoot = 0.25f;

/// Returns the height of a slip face at share t of its length, from the crest down. The face
/// continues in a straight line above the crest.
float slip_face(float t) {
  const float left = 1.0f - t;
  const float rise = left >= kFoot ? left - 0.5f * kFoot : 0.5f * left * left / kFoot;
  return rise / (1.0f - 0.5f * kFoot);
}

void DuneSet::evaluate(const Points& points, DuneBlock& out) const {
  Block spread, spread_dx, spread_dz, bend, bend_dx, bend_dz, size;
  sample(spread_, points, spread, spread_dx, spread_dz);
  sample(sinuosity_, points, bend, bend_dx, bend_dz);
  fbm(size_, points, size);
  const float per_m = 1.0f / wavelength_m_;
  constexpr float kSpread = 1.7f;
  constexpr float kBend = 0.42f;
  for (int i = 0; i < points.count; ++i) {
    const float along = points.x[i] * wind_x_ + points.z[i] * wind_z_;
    const float phase = along * per_m + kSpread * spread[i] + kBend * bend[i];
    const float gx = wind_x_ * per_m + kSpread * spread_dx[i] + kBend * bend_dx[i];
    const float gz = wind_z_ * per_m + kSpread * spread_dz[i] + kBend * bend_dz[i];
    const float gradient = std::sqrt(gx * gx + gz * gz);
    const float t = phase - std::floor(phase);
    // Crests end where the size falls to zero. Closely packed dunes are lower.
    const float height = height_m_ * smooth_step(-0.55f, 0.6f, size[i]) *
                         std::min(1.0f, 1.2f * per_m / std::max(gradient, 1e-6f));
    const float face =
        std::clamp(height * gradient / (kReposeTangent * (1.0f - 0.5f * kFoot)), 1e-4f, 0.6f);
    const float up = t / (1.0f - face);
    const float down = (t - (1.0f - face)) / face;
    // A crest that is too sharp for the spacing of the samples would turn into a row of teeth.
    const float rounding =
        std::min(1.5f * kReposeTangent * points.spacing[i], 0.5f * height) + 1e-3f;
    // A slip face of hardly more than one cell would turn into a row of teeth, too.
    const float share = band_share(0.35f * wavelength_m_, points.spacing[i]);
    out.height[i] = share * smooth_min(height * windward(up), height * slip_face(down), rounding) +
                    (1.0f - share) * 0.45f * height;
    const bool lee = down > 0.0f;
    out.slip[i] = lee ? 1.0f - smooth_step(0.75f, 1.0f, down) : smooth_step(0.7f, 0.95f, up);
  }
}

class DuneSea : public Relief {
 public:
  explicit DuneSea(const scene::Terrain& terrain);

  void heights(const Points& points, Block& height) const override;

 private:
  void add_hills(const Points& points, Block& height) const;

  scene::Terrain terrain_;
  Distortion warp_;
  DuneSet large_;
  DuneSet crossing_;
  DuneSet small_;
  std::vector<Octave> swell_;
  std::vector<Octave> hills_;
  std::vector<Octave> rock_;
};

DuneSea::DuneSea(const scene::Terrain& t)
    : terrain_(t),
      warp_(t.warp_m, t.warp_feature_m, t.seed ^ 0x3C6EF372u),
      large_(t.dunes, 1.0, 0.0, t.seed ^ 0xA54FF53Au),
      crossing_(t.dunes, 0.62, 24.0, t.seed ^ 0x510E527Fu),
      small_(t.dunes, 0.15, -9.0, t.seed ^ 0x9B05688Cu),
      swell_(make_soft_octaves(5.5 * t.dunes.wavelength_m, t.seed ^ 0x1F83D9ABu)),
      hills_(make_soft_octaves(t.feature_m, t.seed ^ 0x5BE0CD19u, 4)),
      rock_(make_octaves(t.fractal, 0.3 * t.feature_m, t.seed ^ 0xCBBB9D5Du)) {}

void DuneSea::heights(const Points& points, Block& height) const {
  DuneBlock large, crossing, small;
  Block swell;
  large_.evaluate(points, large);
  crossing_.evaluate(points, crossing);
  small_.evaluate(points, small);
  fbm(swell_, points, swell);
  const float unit = static_cast<float>(terrain_.dunes.height_m);
  for (int i = 0; i < points.count; ++i) {
    const float sand = smooth_max(large.height[i], crossing.height[i], 0.05f * unit);
    const float lead = (large.height[i] - crossing.height[i]) / std::max(unit, 1e-3f);
    const float slip = mix(crossing.slip[i], large.slip[i], smooth_step(-0.15f, 0.15f, lead));
    height[i] = sand + 0.6f * unit * (swell[i] + 0.5f) + 0.6f * small.height[i] * (1.0f - slip);
  }
  add_hills(points, height);
}

/// Adds table hills, which are noise above a threshold, with a scree foot, a cliff and a flat
/// top.
void DuneSea::add_hills(const Points& points, Block& height) const {
  Points bent = points;
  warp_.apply(bent);
  Block hills, rock;
  fbm(hills_, bent, hills);
  ridged(rock_, static_cast<float>(terrain_.fractal.ridge_offset), bent, rock);
  const auto top = static_cast<float>(terrain_.height_m);
  const auto half = 0.5f * static_cast<float>(terrain_.size_m);
  for (int i = 0; i < points.count; ++i) {
    const float distance = std::sqrt(points.x[i] * points.x[i] + points.z[i] * points.z[i]);
    const float far = smooth_step(0.2f * half, 0.42f * half, distance);
    const float lift = 1.6f * (hills[i] - 0.2f) - 0.5f * (1.0f - far) + 0.14f * (rock[i] - 0.4f);
    if (lift <= 0.0f) continue;
    const float scree = 0.4f * smooth_step(0.0f, 0.2f, lift);
    const float cliff = 0.4f * smooth_step(0.15f, 0.19f, lift);
    const float crown =
        0.2f * smooth_step(0.17f, 0.5f, lift) + 0.08f * smooth_step(0.1f, 0.2f, lift) * rock[i];
    height[i] = mix(height[i], 0.4f * height[i], smooth_step(0.0f, 0.1f, lift)) +
                top * (scree + cliff + crown);
  }
}

}  // namespace

std::unique_ptr<Relief> make_dunes(const scene::Terrain& terrain) {
  return std::make_unique<DuneSea>(terrain);
}

}  // namespace aerostat::terrain
