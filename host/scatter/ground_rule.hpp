#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scatter/solid_noise.hpp"
#include "scene/scene.hpp"

namespace aerostat::scatter {

/// How much of each kind of ground there is at a place, 0 to 1.
struct GroundMix {
  float rock = 0.0f, beach = 0.0f, snow = 0.0f, forest = 0.0f;
};

/// Noise that the rules share.
struct GroundNoise {
  float broad = 0.0f, fine = 0.0f, rough = 0.0f;
};

/// What kernels/device/material/ground_mix.clh says of the ground, on the host: plants grow where
/// it paints them, so that woods of single trees go over into painted ones. Positions lie in the
/// world, in metres; `slope_cos` is the y of the ground's interpolated unit normal.
class GroundRule {
 public:
  /// Detail finer than `footprint_m` is left out.
  GroundRule(const scene::Ground& ground, std::uint32_t seed, float footprint_m);

  /// One for each point. The same bits as one by one.
  std::vector<GroundNoise> noise(std::span<const vec3> points) const;
  /// The same but for `rough`, which is left as it is, and then that by itself.
  void fill_smooth(std::span<const vec3> points, std::span<GroundNoise> noise) const;
  void fill_rough(std::span<const vec3> points, std::span<GroundNoise> noise) const;
  /// mix.forest of ground_mix() there.
  float forest(const vec3& p, float slope_cos, const GroundNoise& noise) const;
  /// No less, whatever the slope and the noise's `rough` are.
  float forest_at_most(const vec3& p, const GroundNoise& noise) const;
  GroundMix mix(const vec3& p, float slope_cos, const GroundNoise& noise) const;

  /// How much the upper limit of trees thins them out, 0 below it, 1 above.
  float thinning(const vec3& p, const GroundNoise& noise) const;
  /// Above 0 in the woods, below it outside; changes slowly.
  float closeness(const vec3& p, const GroundNoise& noise) const;
  /// No tree grows above.
  float highest_tree() const;

  /// Albedo of rock there.
  vec3 rock_color(const vec3& p, const GroundNoise& noise) const;

 private:
  float woods(const vec3& p, const GroundNoise& noise) const;
  float tree_hold(float slope_cos, float ragged) const;
  float beach(float height, float ragged) const;

  scene::Ground ground_;
  float footprint_m_;
  float rock_cos_[2], snow_cos_[2];
  SolidFbm broad_, fine_, rough_;
};

}  // namespace aerostat::scatter
