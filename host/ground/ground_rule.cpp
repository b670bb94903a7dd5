#include "ground/ground_rule.hpp"

#include <algorithm>
#include <cmath>

#include "ground/solid_noise.hpp"

namespace aerostat::ground {
namespace {

vec3 color(const float (&from)[3]) {
  return {from[0], from[1], from[2]};
}

}  // namespace

std::vector<GroundNoise> GroundRule::noise(std::span<const vec3> points) const {
  std::vector<GroundNoise> noise(points.size());
  fill_smooth(points, noise);
  fill_rough(points, noise);
  return noise;
}

void GroundRule::fill_smooth(std::span<const vec3> points, std::span<GroundNoise> noise) const {
  const rules::SolidFbm broad_fbm = rules::broad_fbm(&ground_);
  const rules::SolidFbm fine_fbm = rules::fine_fbm(&ground_);
  Block broad, fine;
  for (std::size_t first = 0; first < points.size(); first += kBlockSize) {
    Spots flat;
    const std::size_t end = std::min(first + kBlockSize, points.size());
    for (std::size_t i = first; i < end; ++i) {
      flat.add({points[i].x, points[i].y * GROUND_NOISE_FLATTENED, points[i].z});
    }
    fill_values(broad_fbm, flat, footprint_m_, broad);
    fill_values(fine_fbm, flat, footprint_m_, fine);
    for (std::size_t i = first; i < end; ++i) {
      noise[i].broad = broad[i - first];
      noise[i].fine = fine[i - first];
      if (cover_ != nullptr) note_cover(points[i], noise[i]);
    }
  }
}

void GroundRule::note_cover(const vec3& p, GroundNoise& noise) const {
  const CoverShares shares = cover_->at(p.x + cover_->cell_m * rules::cover_stray_x(&noise),
                                        p.z + cover_->cell_m * rules::cover_stray_z(&noise));
  rules::note_cover(shares.data(), &noise);
}

void GroundRule::fill_rough(std::span<const vec3> points, std::span<GroundNoise> noise) const {
  const rules::SolidFbm rough_fbm = rules::rough_fbm(&ground_);
  Block rough;
  for (std::size_t first = 0; first < points.size(); first += kBlockSize) {
    Spots spots;
    const std::size_t end = std::min(first + kBlockSize, points.size());
    for (std::size_t i = first; i < end; ++i) spots.add(points[i]);
    fill_values(rough_fbm, spots, footprint_m_, rough);
    for (std::size_t i = first; i < end; ++i) noise[i].rough = rough[i - first];
  }
}

float GroundRule::highest_tree() const {
  if (cover_ != nullptr) return kInfinity;
  const float sway = FOREST_TOP_SWAY * std::fabs(ground_.forest_top);
  return ground_.forest_top + sway * most_of(rules::broad_fbm(&ground_));
}

vec3 GroundRule::rock_color(const vec3& p, const GroundNoise& noise) const {
  return glm::mix(color(ground_.rock_a), color(ground_.rock_b), rules::rock_tone(p.y, &noise));
}

}  // namespace aerostat::ground
