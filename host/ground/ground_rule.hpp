#pragma once

#include <span>
#include <vector>

#include "core/land_cover.hpp"
#include "core/math.hpp"
#include "rules/ground.h"

namespace aerostat::ground {

using rules::GroundMix;
using rules::GroundNoise;

/// Applies the rules of kernels/rules/ground.h on the host. Plants grow where these paint them, so
/// that woods of single trees pass into painted woods. Positions are over the terrain in metres,
/// and their heights are those above the sea.
/// `slope_cos` is the y of the ground's interpolated unit normal.
class GroundRule {
 public:
  /// Makes the rule of a ground. Detail finer than `footprint_m` metres is left out.
  /// `cover` is the land cover that the ground has, if it has any; it must outlive the rule.
  GroundRule(const AeroGround& ground, float footprint_m, const CoverLookup* cover = nullptr)
      : ground_(ground), footprint_m_(footprint_m), cover_(cover) {}

  /// Returns the noise of each point. The bits do not depend on how the points are grouped.
  std::vector<GroundNoise> noise(std::span<const vec3> points) const;
  /// Fills all noise and what land cover says, except `rough`, which is left as it is. `fill_rough`
  /// fills only `rough`.
  void fill_smooth(std::span<const vec3> points, std::span<GroundNoise> noise) const;
  void fill_rough(std::span<const vec3> points, std::span<GroundNoise> noise) const;

  GroundMix mix(const vec3& p, float slope_cos, const GroundNoise& noise) const {
    return rules::ground_mix(&ground_, p.y, slope_cos, slope_cos, &noise);
  }
  /// Returns the forest of the mix at a place.
  float forest(const vec3& p, float slope_cos, const GroundNoise& noise) const {
    return rules::forest_share(&ground_, p.y, slope_cos, &noise);
  }
  /// Returns an upper bound of `forest` for every slope and every value of the noise's `rough`.
  float forest_at_most(const vec3& p, const GroundNoise& noise) const {
    const bool none = !(ground_.forest_share > 0.0f) && ground_.has_cover == 0u;
    return none ? 0.0f : rules::forest_wished(&ground_, p.y, &noise);
  }
  /// Returns how much the tree line thins out the trees, from 0 below it to 1 above it.
  float thinning(const vec3& p, const GroundNoise& noise) const {
    return rules::forest_thinning(&ground_, p.y, &noise);
  }
  /// Returns a slowly changing value that is above 0 in the woods and below 0 outside.
  float closeness(const vec3& p, const GroundNoise& noise) const {
    return rules::forest_closeness(&ground_, p.y, &noise);
  }
  /// Returns the field at a place. There are fields if the ground has a width of them.
  rules::FieldAt field(const vec3& p, float slope_cos, const GroundNoise& noise) const {
    return rules::field_at(&ground_, p.x, p.z, slope_cos, &noise);
  }
  bool has_cover() const { return cover_ != nullptr; }
  bool has_fields() const { return ground_.field_width > 0.0f; }
  /// Returns the height of the ground above the sea.
  float height_above_sea(const vec3& p) const {
    return rules::height_above_sea(&ground_, p.x, p.y, p.z);
  }
  /// Returns the height above which no tree grows.
  float highest_tree() const;

  /// Returns the albedo of the rock at a place.
  vec3 rock_color(const vec3& p, const GroundNoise& noise) const;

 private:
  void note_cover(const vec3& p, GroundNoise& noise) const;

  AeroGround ground_;
  float footprint_m_;
  const CoverLookup* cover_;
};

}  // namespace aerostat::ground
