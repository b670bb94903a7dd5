#include "scatter/ground_rule.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/smooth_step.hpp"

namespace aerostat::scatter {
namespace {

float frayed_step(float lo, float hi, float x, float ragged) {
  const float t = (x - lo) / (hi - lo);
  return smooth_step(0.475f, 0.525f, t + 0.34f * ragged);
}

/// Returns the noise that frays the borders between kinds of ground.
float ragged(const GroundNoise& noise) {
  return 0.3f * noise.broad + 1.5f * noise.fine - 0.6f * noise.rough;
}

float cosine_of_deg(double degrees) {
  return static_cast<float>(std::cos(degrees * (std::numbers::pi / 180.0)));
}

}  // namespace

GroundRule::GroundRule(const scene::Ground& ground, std::uint32_t seed, float footprint_m)
    : ground_(ground), footprint_m_(footprint_m) {
  for (int i = 0; i < 2; ++i) {
    rock_cos_[i] = cosine_of_deg(ground.rock_slope_deg[i]);
    snow_cos_[i] = cosine_of_deg(ground.snow_slope_deg[i]);
  }
  const auto width = static_cast<float>(ground.pattern_m);
  broad_ = {seed + 101u, width * 4.0f, 4, 0.6f, false};
  fine_ = {seed + 211u, width * 0.4f, 7, 0.74f, false};
  rough_ = {seed + 307u, width * 0.8f, 8, 0.55f, true};
}

std::vector<GroundNoise> GroundRule::noise(std::span<const vec3> points) const {
  std::vector<GroundNoise> noise(points.size());
  fill_smooth(points, noise);
  fill_rough(points, noise);
  return noise;
}

void GroundRule::fill_smooth(std::span<const vec3> points, std::span<GroundNoise> noise) const {
  Block broad, fine;
  for (std::size_t first = 0; first < points.size(); first += kBlockSize) {
    Spots flat;
    const std::size_t end = std::min(first + kBlockSize, points.size());
    for (std::size_t i = first; i < end; ++i)
      flat.add({points[i].x, points[i].y * 0.4f, points[i].z});
    broad_.at(flat, footprint_m_, broad);
    fine_.at(flat, footprint_m_, fine);
    for (std::size_t i = first; i < end; ++i) {
      noise[i].broad = broad[i - first];
      noise[i].fine = fine[i - first];
    }
  }
}

void GroundRule::fill_rough(std::span<const vec3> points, std::span<GroundNoise> noise) const {
  Block rough;
  for (std::size_t first = 0; first < points.size(); first += kBlockSize) {
    Spots spots;
    const std::size_t end = std::min(first + kBlockSize, points.size());
    for (std::size_t i = first; i < end; ++i) spots.add(points[i]);
    rough_.at(spots, footprint_m_, rough);
    for (std::size_t i = first; i < end; ++i) noise[i].rough = rough[i - first];
  }
}

float GroundRule::highest_tree() const {
  const auto top = static_cast<float>(ground_.forest_top_m);
  return top + 0.25f * std::fabs(top) * broad_.most();
}

float GroundRule::thinning(const vec3& p, const GroundNoise& noise) const {
  const auto top = static_cast<float>(ground_.forest_top_m);
  return smooth_step(top * 0.6f, top, p.y + 0.25f * top * noise.broad);
}

float GroundRule::closeness(const vec3& p, const GroundNoise& noise) const {
  const auto share = static_cast<float>(ground_.forest_share);
  const float wish = 2.0f * share * (1.0f - thinning(p, noise)) - 1.0f;
  return wish + 0.6f * noise.broad + 0.5f * noise.fine;
}

float GroundRule::woods(const vec3& p, const GroundNoise& noise) const {
  return smooth_step(-0.03f, 0.03f, closeness(p, noise));
}

float GroundRule::tree_hold(float slope_cos, float ragged) const {
  return frayed_step(rock_cos_[1] - 0.06f, rock_cos_[0] - 0.06f, slope_cos, -ragged);
}

float GroundRule::beach(float height, float ragged) const {
  const auto top = static_cast<float>(ground_.beach_top_m);
  return 1.0f - smooth_step(top - 0.5f, top + 0.5f, height + 2.0f * ragged);
}

float GroundRule::forest(const vec3& p, float slope_cos, const GroundNoise& noise) const {
  if (!(ground_.forest_share > 0.0)) return 0.0f;
  const float fray = ragged(noise);
  return woods(p, noise) * tree_hold(slope_cos, fray) * (1.0f - beach(p.y, fray));
}

float GroundRule::forest_at_most(const vec3& p, const GroundNoise& noise) const {
  return ground_.forest_share > 0.0 ? woods(p, noise) : 0.0f;
}

GroundMix GroundRule::mix(const vec3& p, float slope_cos, const GroundNoise& noise) const {
  const float fray = ragged(noise);
  const auto line = static_cast<float>(ground_.snow_line_m);
  const auto half_zone = 0.5f * static_cast<float>(ground_.snow_fuzz_m);
  const float swept = 0.9f * noise.broad + 0.22f * noise.fine - 0.2f * noise.rough;
  GroundMix mix;
  mix.rock = frayed_step(-rock_cos_[0], -rock_cos_[1], -slope_cos, fray);
  const float shore = beach(p.y, fray);
  mix.beach = shore * smooth_step(0.9f, 0.95f, slope_cos + 0.02f * fray);
  mix.rock = std::max(mix.rock, shore - mix.beach);
  mix.snow = frayed_step(line - half_zone, line + half_zone, p.y, 1.5f * fray) *
             frayed_step(snow_cos_[1], snow_cos_[0], slope_cos, swept);
  mix.forest = forest(p, slope_cos, noise);
  return mix;
}

vec3 GroundRule::rock_color(const vec3& p, const GroundNoise& noise) const {
  const float bed = 0.5f * std::sin(kPi * (p.y * 0.045f + 2.2f * noise.broad));
  const float t =
      std::clamp(0.5f + 0.9f * noise.fine - 0.6f * noise.rough + 0.3f * bed, 0.0f, 1.0f);
  return glm::mix(ground_.rock_a, ground_.rock_b, t);
}

}  // namespace aerostat::scatter
