#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scatter/solid_noise.hpp"
#include "scene/scene.hpp"

namespace aerostat::scatter {

/// The amount of each kind of ground at a place, from 0 to 1.
struct GroundMix {
  float rock = 0.0f, beach = 0.0f, snow = 0.0f, forest = 0.0f;
};

/// The values of the noise that the rules share.
struct GroundNoise {
  float broad = 0.0f, fine = 0.0f, rough = 0.0f;
};

/// Computes on the host the same mix of the ground as kernels/device/material/ground_mix.clh.
/// Plants grow where this mix paints them, so that woods of single trees pass into painted woods.
/// Positions are in the world in metres. `slope_cos` is the y of the ground's interpolated unit
/// normal.
class GroundRule {
 public:
  /// Makes the rule of a ground. Detail finer than `footprint_m` metres is left out.
  GroundRule(const scene::Ground& ground, std::uint32_t seed, float footprint_m);

  /// Returns the noise of each point. The bits do not depend on how the points are grouped.
  std::vector<GroundNoise> noise(std::span<const vec3> points) const;
  /// Fills all noise except `rough`, which is left as it is. `fill_rough` fills only `rough`.
  void fill_smooth(std::span<const vec3> points, std::span<GroundNoise> noise) const;
  void fill_rough(std::span<const vec3> points, std::span<GroundNoise> noise) const;
  /// Returns the forest of the mix at a place.
  float forest(const vec3& p, float slope_cos, const GroundNoise& noise) const;
  /// Returns an upper bound of `forest` for every slope and every value of the noise's `rough`.
  float forest_at_most(const vec3& p, const GroundNoise& noise) const;
  GroundMix mix(const vec3& p, float slope_cos, const GroundNoise& noise) const;

  /// Returns how much the tree line thins out the trees, from 0 below it to 1 above it.
  float thinning(const vec3& p, const GroundNoise& noise) const;
  /// Returns a slowly changing value that is above 0 in the woods and below 0 outside.
  float closeness(const vec3& p, const GroundNoise& noise) const;
  /// Returns the height above which no tree grows.
  float highest_tree() const;

  /// Returns the albedo of the rock at a place.
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
