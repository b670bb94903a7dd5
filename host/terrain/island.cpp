#include <algorithm>
#include <cmath>

#include "blend.hpp"
#include "core/smooth_step.hpp"
#include "drainage.hpp"
#include "fractal.hpp"
#include "gullies.hpp"
#include "relief.hpp"

namespace aerostat::terrain {
namespace {

// The depths, in metres, of a fringing reef: the sandy lagoon, the flat of the reef, and the sea
// behind the fore reef. Chosen by eye.
constexpr float kLagoonDepth = 7.0f;
constexpr float kReefDepth = 2.2f;
constexpr float kDeep = 160.0f;
constexpr double kWidestGully = 0.075;  // share of the feature's wavelength
constexpr float kGullyDepth = 0.4f;

class Island : public Relief {
 public:
  Island(const scene::Terrain& terrain, Carving carving);

  void heights(const Points& points, Block& height) const override;

 private:
  void shore_distance(const Points& points, Block& inland) const;
  void plain_width(const Points& points, Block& width) const;
  void hills(const Points& points, const Points& bent, const Jacobian& bends, Block& height) const;
  void survey(const Points& points, Bedrock* rock) const;
  float sea_bed(float offshore, float reef_at, float bumps) const;

  scene::Terrain terrain_;
  Distortion bends_;
  std::vector<Octave> coast_;
  std::vector<Octave> plain_;
  std::vector<Octave> massif_;
  std::vector<Octave> detail_;
  std::vector<Octave> bumps_;
  Gullies gullies_;
  float detail_m_ = 0.0f;
  float radius_m_;
  float island_x_ = 0.0f;
  float island_z_ = 0.0f;
  float origin_x_ = 0.0f;  // place to which the distortion moves the terrain's centre
  float origin_z_ = 0.0f;
  float bay_z_ = 0.0f;
  float bay_m_ = 0.0f;
  HeightGrid carved_;
};

Island::Island(const scene::Terrain& t, Carving carving)
    : terrain_(t),
      bends_(t.warp_m, t.warp_feature_m, t.seed ^ 0x3C6EF372u, 5),
      coast_(make_soft_octaves(0.8 * t.feature_m, t.seed ^ 0x510E527Fu, 5)),
      plain_(make_soft_octaves(0.5 * t.feature_m, t.seed ^ 0xCBBB9D5Du)),
      massif_(make_soft_octaves(t.feature_m, t.seed ^ 0xA54FF53Au, 3)),
      bumps_(make_soft_octaves(260.0, t.seed ^ 0x1F83D9ABu, 4)),
      gullies_(kWidestGully * t.feature_m, 4, kGullyDepth, t.seed ^ 0x27D4EB2Fu),
      radius_m_(0.22f * static_cast<float>(t.size_m)) {
  const float turn = static_cast<float>(lattice_hash(t.seed, 7, 11) >> 8) / 16777216.0f;
  // The island lies ahead (-z) and to one side. The bay opens around the centre.
  const float angle = (turn < 0.5f ? -1.0f : 1.0f) * (0.35f + 0.5f * std::fabs(turn - 0.5f));
  bay_m_ = 0.2f * static_cast<float>(t.feature_m);
  bay_z_ = 0.3f * bay_m_;
  island_x_ = std::sin(angle) * radius_m_ * 0.95f;
  island_z_ = -std::cos(angle) * radius_m_ * 0.95f;
  Points origin;
  origin.count = 1;
  origin.x[0] = origin.z[0] = origin.spacing[0] = 0.0f;
  bends_.apply(origin);
  origin_x_ = origin.x[0];
  origin_z_ = origin.z[0];
  DrainageOptions options;
  options.size_m = t.size_m + 2.0 * t.warp_m;
  options.height_m = t.height_m;
  options.seed = t.seed;
  options.levels_left_out = carving == Carving::coarse ? kCoarseLevelsLeftOut : 0;
  options.floor_m = 45.0f;
  options.floor_area_km2 = 1.0f;
  options.concavity = 0.42f;
  const double cell = options.size_m / ((options.coarse_nodes - 1) << (options.rounds.size() - 1));
  for (const Octave& octave : make_octaves(t.fractal, 6.0 * cell, t.seed ^ 0x51ED270Bu))
    detail_.push_back(octave);
  detail_m_ = 0.22f * static_cast<float>(6.0 * cell);
  carved_ =
      sharpen(carve_valleys(options, [this](const Points& p, Bedrock* rock) { survey(p, rock); }));
}

/// Computes the metres from the shore, positive on land. They are only roughly a distance, but
/// their slope is near 1.
void Island::shore_distance(const Points& points, Block& inland) const {
  Block coast;
  fbm(coast_, points, coast);
  const auto feature = static_cast<float>(terrain_.feature_m);
  for (int i = 0; i < points.count; ++i) {
    const float x = points.x[i] - origin_x_;
    const float z = points.z[i] - origin_z_;
    const float island = radius_m_ - std::hypot(x - island_x_, z - island_z_);
    const float bay = std::hypot(x, z - bay_z_) - bay_m_;
    const float rim =
        0.43f * static_cast<float>(terrain_.size_m) - std::hypot(points.x[i], points.z[i]);
    const float land = smooth_min(island + 0.95f * feature * coast[i],
                                  bay + 0.22f * feature * coast[i], 0.5f * bay_m_);
    inland[i] = smooth_min(land, rim, 0.1f * feature);
  }
}

/// Computes the width of the flat land behind the beach. It is zero at headlands and greatest in
/// the bay.
void Island::plain_width(const Points& points, Block& width) const {
  fbm(plain_, points, width);
  for (int i = 0; i < points.count; ++i) {
    const float from_bay = std::hypot(points.x[i] - origin_x_, points.z[i] - origin_z_) / bay_m_;
    const float bay = 1.0f - smooth_step(1.2f, 3.0f, from_bay);
    width[i] = 0.11f * static_cast<float>(terrain_.feature_m) *
               std::max(smooth_step(-0.2f, 0.5f, width[i]), 0.7f * bay);
  }
}

void Island::survey(const Points& points, Bedrock* rock) const {
  Block inland, massif, plain;
  shore_distance(points, inland);
  plain_width(points, plain);
  fbm(massif_, points, massif);
  for (int i = 0; i < points.count; ++i) {
    const float range = smooth_step(-0.35f, 0.5f, massif[i]);
    const float rise = smooth_step(0.0f, 0.45f * radius_m_, inland[i]);
    const float hills = smooth_step(0.6f * plain[i], plain[i] + 60.0f, inland[i]);
    rock[i].uplift = (0.2f + 1.4f * range * range + 1.2f * rise) * mix(0.1f, 1.0f, hills);
    const float from_bay = std::hypot(points.x[i] - origin_x_, points.z[i] - origin_z_) / bay_m_;
    const float open = 1.0f - smooth_step(1.3f, 3.4f, from_bay);
    rock[i].steepest =
        mix(0.03f, (0.35f + 0.4f * range + 0.45f * rise) * mix(1.0f, 0.65f, open), hills);
    rock[i].outlet = inland[i] < 0.0f;
    rock[i].outlet_m = 0.0f;
  }
}

/// Returns the height of the ground under water: a sandy lagoon with patches, the flat of the
/// reef and the fore reef.
float Island::sea_bed(float offshore, float reef_at, float bumps) const {
  const float shelf = kLagoonDepth + 2.5f * bumps;
  const float inner = smooth_min(0.06f * offshore, shelf, 5.0f);
  const float crest = smooth_step(0.75f * reef_at, reef_at, offshore);
  const float flat = mix(inner, std::min(inner, kReefDepth + bumps), crest);
  return -mix(flat, kDeep, smooth_step(reef_at, 2.0f * reef_at + 400.0f, offshore));
}

/// Computes the heights of the hills that rivers have carved, with their gullies.
void Island::hills(const Points& points, const Points& bent, const Jacobian& bends,
                   Block& height) const {
  Slopes ground;
  Block detail, dx, dz, strength;
  sample(carved_, bent, ground.height, dx, dz);
  ridged(detail_, static_cast<float>(terrain_.fractal.ridge_offset), points, detail);
  const float top = std::max(static_cast<float>(terrain_.height_m), 1.0f);
  const auto sharpness = static_cast<float>(terrain_.sharpness);
  const auto erosion = static_cast<float>(terrain_.erosion);
  for (int i = 0; i < points.count; ++i) {
    const float slope = std::hypot(dx[i], dz[i]);
    ground.height[i] = top * std::pow(std::max(ground.height[i], 0.0f) / top, sharpness) +
                       detail_m_ * smooth_step(0.1f, 0.7f, slope) * (detail[i] - 0.4f);
    ground.dx[i] = dx[i] * bends.x_by_x[i] + dz[i] * bends.z_by_x[i];
    ground.dz[i] = dx[i] * bends.x_by_z[i] + dz[i] * bends.z_by_z[i];
    strength[i] = erosion * smooth_step(0.12f, 0.5f, slope);
  }
  gullies_.add(points, strength, ground);
  std::copy_n(ground.height.begin(), points.count, height.begin());
}

void Island::heights(const Points& points, Block& height) const {
  Points bent = points;
  Jacobian bends;
  bends_.apply(bent, bends);
  Block inland, bumps, plain;
  shore_distance(bent, inland);
  plain_width(bent, plain);
  hills(points, bent, bends, height);
  fbm(bumps_, points, bumps);
  for (int i = 0; i < points.count; ++i) {
    const float widest = 0.11f * static_cast<float>(terrain_.feature_m);
    if (inland[i] < 0.0f) {
      height[i] = sea_bed(-inland[i], 1.2f * widest + 1.6f * plain[i], bumps[i]);
      continue;
    }
    // Beaches are broad and gentle before flat land, and short and steep at headlands.
    const float rise = mix(0.17f, 0.045f, smooth_step(0.0f, 0.8f, plain[i] / widest));
    const float beach = smooth_min(rise * inland[i], 2.5f + 0.008f * inland[i], 2.0f);
    height[i] = beach + (std::max(height[i], 0.0f) + 1.5f * std::max(bumps[i], 0.0f)) *
                            smooth_step(8.0f, 60.0f, inland[i]);
  }
}

}  // namespace

std::unique_ptr<Relief> make_island(const scene::Terrain& terrain, Carving carving) {
  return std::make_unique<Island>(terrain, carving);
}

}  // namespace aerostat::terrain
