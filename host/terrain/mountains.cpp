#include <algorithm>
#include <cmath>
#include <numbers>

#include "blend.hpp"
#include "core/simd.hpp"
#include "core/smooth_step.hpp"
#include "drainage.hpp"
#include "fractal.hpp"
#include "gullies.hpp"
#include "relief.hpp"

namespace aerostat::terrain {
namespace {

constexpr float kFloorRelief = 20.0f;  // metres; valley floors are not quite flat
constexpr float kLeastHeight = 1.0f;
constexpr double kWidestGully = 0.065;  // share of the feature's wavelength
constexpr float kGullyDepth = 0.5f;

class Mountains : public Relief {
 public:
  Mountains(const scene::Terrain& terrain, Carving carving);

  void heights(const Points& points, Block& height) const override;

 private:
  void survey(const Points& points, Bedrock* rock) const;
  void carved_ground(const Points& points, Slopes& ground) const;
  void river_distance(const Points& points, Block& distance) const;

  scene::Terrain terrain_;
  Distortion bends_;
  std::vector<Octave> river_;
  std::vector<Octave> massif_;
  std::vector<Octave> strength_;
  std::vector<Octave> detail_;
  std::vector<Octave> floor_;
  Gullies gullies_;
  float detail_m_ = 0.0f;
  float axis_x_ = 0.0f;
  float axis_z_ = -1.0f;
  float river_at_center_ = 0.0f;
  HeightGrid carved_;
};

/// Splits the octaves into those that shape the uplift and those that are too fine for the carved
/// grid, which become detail.
void split_octaves(const scene::Terrain& t, float finest_m, std::vector<Octave>& coarse,
                   std::vector<Octave>& fine) {
  for (const Octave& octave : make_octaves(t.fractal, t.feature_m, t.seed ^ 0x51ED270Bu))
    (octave.layer.wavelength_m > finest_m ? coarse : fine).push_back(octave);
}

Mountains::Mountains(const scene::Terrain& terrain, Carving carving)
    : terrain_(terrain),
      bends_(terrain.warp_m, terrain.warp_feature_m, terrain.seed ^ 0x3C6EF372u, 6),
      river_(make_soft_octaves(1.3 * terrain.feature_m, terrain.seed ^ 0x9B05688Cu)),
      strength_(make_soft_octaves(0.25 * terrain.feature_m, terrain.seed ^ 0x1F83D9ABu, 3)),
      floor_(make_soft_octaves(0.15 * terrain.feature_m, terrain.seed ^ 0x5BE0CD19u, 5)),
      gullies_(kWidestGully * terrain.feature_m, 5, kGullyDepth, terrain.seed ^ 0x27D4EB2Fu) {
  DrainageOptions options;
  options.size_m = terrain.size_m + 2.0 * terrain.warp_m;
  options.height_m = terrain.height_m;
  options.seed = terrain.seed;
  options.levels_left_out = carving == Carving::coarse ? kCoarseLevelsLeftOut : 0;
  const double cell = options.size_m / ((options.coarse_nodes - 1) << (options.rounds.size() - 1));
  split_octaves(terrain, static_cast<float>(6.0 * cell), massif_, detail_);
  if (!detail_.empty()) detail_m_ = 0.24f * detail_.front().layer.wavelength_m;
  const float turn = static_cast<float>(lattice_hash(terrain.seed, 7, 11) >> 8) / 16777216.0f;
  const float angle = (turn - 0.5f) * 1.0f;
  axis_x_ = std::sin(angle);
  axis_z_ = -std::cos(angle);
  Points center;
  center.count = 1;
  center.x[0] = center.z[0] = center.spacing[0] = 0.0f;
  bends_.apply(center);
  Block river;
  river_distance(center, river);
  river_at_center_ = river[0];
  carved_ =
      sharpen(carve_valleys(options, [this](const Points& p, Bedrock* rock) { survey(p, rock); }));
}

/// Computes the signed distance across the main valley from its river, which winds along a
/// straight axis.
void Mountains::river_distance(const Points& points, Block& distance) const {
  Points on_axis = points;
  for (int i = 0; i < points.count; ++i) {
    const float along = points.x[i] * axis_x_ + points.z[i] * axis_z_;
    on_axis.x[i] = along * axis_x_;
    on_axis.z[i] = along * axis_z_;
  }
  fbm(river_, on_axis, distance);
  const float swing = 0.45f * static_cast<float>(terrain_.feature_m);
  for (int i = 0; i < points.count; ++i)
    distance[i] =
        points.x[i] * axis_z_ - points.z[i] * axis_x_ + swing * distance[i] - river_at_center_;
}

void Mountains::survey(const Points& points, Bedrock* rock) const {
  Block river;
  Block massif;
  Block strength;
  river_distance(points, river);
  ridged(massif_, static_cast<float>(terrain_.fractal.ridge_offset), points, massif);
  fbm(strength_, points, strength);
  const auto feature = static_cast<float>(terrain_.feature_m);
  for (int i = 0; i < points.count; ++i) {
    const float distance = std::fabs(river[i]);
    const float along = points.x[i] * axis_x_ + points.z[i] * axis_z_;
    const float open =
        1.0f - smooth_step(0.06f, 0.45f, std::hypot(distance, 0.4f * along) / feature);
    rock[i].uplift = (0.1f + 4.0f * massif[i] * massif[i] * massif[i]) * mix(1.0f, 0.4f, open);
    rock[i].steepest = (0.4f + 0.7f * massif[i] + 0.35f * strength[i]) * mix(1.0f, 0.5f, open);
    rock[i].outlet = distance < 0.07f * feature * (1.0f + 0.9f * strength[i]);
    rock[i].outlet_m = 0.004f * along + 0.0025f * static_cast<float>(terrain_.size_m);
  }
}

/// Computes the ground that rivers have carved, with its gradient in the plane that is not bent.
void Mountains::carved_ground(const Points& points, Slopes& ground) const {
  Points bent = points;
  Jacobian bends;
  bends_.apply(bent, bends);
  // The arrays are in one object, so that compilers see that they do not overlap.
  struct {
    Block dx, dz, bent_share;
  } carved;
  sample(carved_, bent, ground.height, carved.dx, carved.dz);
  const float top = std::max(static_cast<float>(terrain_.height_m), kLeastHeight);
  const auto sharpness = static_cast<float>(terrain_.sharpness);
  for (int i = 0; i < points.count; ++i) {
    const float share = std::max(ground.height[i], 0.0f) / top;
    carved.bent_share[i] = sharpness == 1.0f ? share : std::pow(share, sharpness);
  }
  in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
    for (int i = 0; i < points.count; ++i) {
      const float share = std::max(ground.height[i], 0.0f) / top;
      const float least = share > 1e-4f ? share : 1.0f;
      const float steeper = sharpness * carved.bent_share[i] / least;
      const float factor = share > 1e-4f ? steeper : 1.0f;
      const float dx = carved.dx[i], dz = carved.dz[i];
      ground.height[i] = top * carved.bent_share[i];
      ground.dx[i] = factor * (dx * bends.x_by_x[i] + dz * bends.z_by_x[i]);
      ground.dz[i] = factor * (dx * bends.x_by_z[i] + dz * bends.z_by_z[i]);
    }
  });
}

void Mountains::heights(const Points& points, Block& height) const {
  Slopes ground;
  carved_ground(points, ground);
  Block detail;
  ridged(detail_, static_cast<float>(terrain_.fractal.ridge_offset), points, detail);
  Block floor;
  fbm(floor_, points, floor);
  Block strength;
  const auto erosion = static_cast<float>(terrain_.erosion);
  in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
    const float detail_m = detail_m_;
    for (int i = 0; i < points.count; ++i) {
      const float slope = length_of(ground.dx[i], ground.dz[i]);
      const float rough = smooth_step(0.1f, 0.8f, slope);
      strength[i] = erosion * smooth_step(0.12f, 0.5f, slope);
      ground.height[i] += detail_m * rough * (1.0f - 0.5f * erosion) * (detail[i] - 0.4f) +
                          kFloorRelief * (1.0f - rough) * floor[i];
    }
  });
  gullies_.add(points, strength, ground);
  std::copy_n(ground.height.begin(), points.count, height.begin());
}

}  // namespace

std::unique_ptr<Relief> make_mountains(const scene::Terrain& terrain, Carving carving) {
  return std::make_unique<Mountains>(terrain, carving);
}

}  // namespace aerostat::terrain
