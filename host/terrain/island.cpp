#include "blend.hpp"
#include "drainage.hpp"
#include "fractal.hpp"
#include "relief.hpp"

namespace aerostat::terrain {
namespace {

// Depths of a fringing reef: a sandy lagoon, the reef's flat, then the fore reef falls away.
constexpr float kLagoonDepth = 7.0f;
constexpr float kReefDepth = 2.0f;
constexpr float kDeep = 160.0f;

class Island : public Relief {
 public:
  explicit Island(const scene::Terrain& terrain);

  void heights(const Points& points, Block& height) const override;

 private:
  void shore_distance(const Points& points, Block& inland) const;
  void survey(const Points& points, Bedrock* rock) const;
  float sea_bed(float offshore, float lagoon, float bumps) const;

  scene::Terrain terrain_;
  Distortion bends_;
  std::vector<Octave> coast_;
  std::vector<Octave> massif_;
  std::vector<Octave> detail_;
  std::vector<Octave> bumps_;
  float detail_m_ = 0.0f;
  float radius_m_;
  float island_x_ = 0.0f;
  float island_z_ = 0.0f;
  float bay_x_ = 0.0f;
  float bay_z_ = 0.0f;
  float bay_m_ = 0.0f;
  HeightGrid carved_;
};

Island::Island(const scene::Terrain& t)
    : terrain_(t),
      bends_(t.warp_m, t.warp_feature_m, t.seed ^ 0x3C6EF372u, 5),
      coast_(make_soft_octaves(0.8 * t.feature_m, t.seed ^ 0x510E527Fu, 5)),
      massif_(make_soft_octaves(t.feature_m, t.seed ^ 0xA54FF53Au, 3)),
      bumps_(make_soft_octaves(260.0, t.seed ^ 0x1F83D9ABu, 4)),
      radius_m_(0.25f * static_cast<float>(t.size_m)) {
  const float turn = static_cast<float>(lattice_hash(t.seed, 7, 11) >> 8) / 16777216.0f;
  // The island lies ahead (-z) and to one side; the bay opens around the centre.
  const float angle = (turn < 0.5f ? -1.0f : 1.0f) * (0.35f + 0.5f * std::fabs(turn - 0.5f));
  bay_m_ = 0.33f * static_cast<float>(t.feature_m);
  bay_z_ = 0.35f * bay_m_;
  island_x_ = std::sin(angle) * radius_m_ * 0.95f;
  island_z_ = -std::cos(angle) * radius_m_ * 0.95f;
  DrainageOptions options;
  options.size_m = t.size_m + 2.0 * t.warp_m;
  options.height_m = t.height_m;
  options.seed = t.seed;
  options.floor_m = 45.0f;
  options.floor_area_km2 = 1.0f;
  options.concavity = 0.42f;
  const double cell = options.size_m / ((options.coarse_nodes - 1) << (options.rounds.size() - 1));
  for (const Octave& octave : make_octaves(t.fractal, 6.0 * cell, t.seed ^ 0x51ED270Bu))
    detail_.push_back(octave);
  detail_m_ = 0.22f * static_cast<float>(6.0 * cell);
  carved_ = carve_valleys(options, [this](const Points& p, Bedrock* rock) { survey(p, rock); });
}

/// Metres from the shore, positive on land; only roughly a distance, but with a slope near 1.
void Island::shore_distance(const Points& points, Block& inland) const {
  Block coast;
  fbm(coast_, points, coast);
  const float headlands = 0.3f * static_cast<float>(terrain_.feature_m);
  for (int i = 0; i < points.count; ++i) {
    const float island = radius_m_ - std::hypot(points.x[i] - island_x_, points.z[i] - island_z_);
    const float bay = std::hypot(points.x[i] - bay_x_, points.z[i] - bay_z_) - bay_m_;
    const float rim = 0.46f * static_cast<float>(terrain_.size_m) -
                      std::max(std::fabs(points.x[i]), std::fabs(points.z[i]));
    inland[i] = smooth_min(island + 1.6f * headlands * coast[i], bay + 0.8f * headlands * coast[i],
                           0.25f * bay_m_);
  }
}

void Island::survey(const Points& points, Bedrock* rock) const {
  Block inland, massif;
  shore_distance(points, inland);
  fbm(massif_, points, massif);
  for (int i = 0; i < points.count; ++i) {
    const float range = ramp(-0.35f, 0.5f, massif[i]);
    const float rise = ramp(0.0f, 0.35f * radius_m_, inland[i]);
    rock[i].uplift = 0.25f + 1.5f * range * range + 1.2f * rise;
    rock[i].steepest = 0.35f + 0.4f * range + 0.45f * rise;
    rock[i].outlet = inland[i] < 0.0f;
    rock[i].outlet_m = 0.0f;
  }
}

float Island::sea_bed(float offshore, float lagoon, float bumps) const {
  const float reef_at = 700.0f * lagoon;
  const float slope = 0.07f * offshore;
  const float inner = smooth_min(slope, kLagoonDepth + 2.0f * bumps, 4.0f);
  const float reef = ramp(0.7f * reef_at, reef_at, offshore);
  const float flat = mix(inner, kReefDepth + 0.8f * bumps, 0.75f * reef);
  const float fall = ramp(reef_at, reef_at + 900.0f, offshore);
  return -mix(flat, kDeep, fall);
}

void Island::heights(const Points& points, Block& height) const {
  Points bent = points;
  bends_.apply(bent);
  Block inland, slope, detail, bumps, carved;
  shore_distance(bent, inland);
  sample(carved_, bent, carved, slope);
  ridged(detail_, static_cast<float>(terrain_.fractal.ridge_offset), points, detail);
  fbm(bumps_, points, bumps);
  for (int i = 0; i < points.count; ++i) {
    if (inland[i] < 0.0f) {
      height[i] = sea_bed(-inland[i], 1.0f + 0.5f * bumps[i], bumps[i]);
      continue;
    }
    const float rough = ramp(0.1f, 0.7f, slope[i]);
    const float beach = 0.07f * inland[i];
    const float plain = smooth_min(beach, 2.5f + 0.01f * inland[i], 2.0f);
    const float hills = carved[i] + detail_m_ * rough * (detail[i] - 0.4f) + 1.5f * bumps[i];
    height[i] = plain + std::max(hills, 0.0f) * ramp(10.0f, 120.0f, inland[i]);
  }
}

}  // namespace

std::unique_ptr<Relief> make_island(const scene::Terrain& terrain) {
  return std::make_unique<Island>(terrain);
}

}  // namespace aerostat::terrain
