#pragma once

#include <functional>
#include <vector>

#include "plant/random.hpp"
#include "scatter/ground_rule.hpp"
#include "scatter/scatter.hpp"
#include "scatter/sight.hpp"
#include "scatter/surface.hpp"

namespace aerostat::scatter {

/// A place where something may grow.
struct Site {
  vec3 position{0.0f};  // over the terrain, as all positions here
  vec3 normal{0.0f, 1.0f, 0.0f};
  float above_sea = 0.0f;  // metres; far above where there is no sea
  GroundNoise noise;
};

/// What stands at a place.
struct Choice {
  plant::ModelKey model;
  float scale = 1.0f;
  float upright = 1.0f;  // 1: stands plumb, 0: at right angles to the ground
  vec2 lean{0.0f};       // tilt of the axis in x and z, as tangents, on top of that
  vec3 tint{1.0f};
};

/// One kind of growth: a jittered grid with a candidate in every square.
struct Layer {
  std::uint32_t id = 0;       // sets its grid and its random numbers apart
  double spacing_m = 10.0;    // side of a square
  double reach_m = 1000.0;    // nothing beyond; thins out over the outer half
  float lowest = -kInfinity;  // heights of the ground
  float highest = kInfinity;
  float steepest_cos = 0.0f;  // of the slope
  float most = 1.0f;          // bound of `chance`
  /// The probability that a candidate grows, by its site.
  std::function<float(const Site&)> chance;
  /// No less than that, by all but the noise's `rough`, which is dear; null: `most` is all that is
  /// known.
  std::function<float(const Site&)> chance_at_most;
  std::function<Choice(const Site&, plant::Random&)> choose;
};

/// What the layers are placed upon. Squares are counted by places over the terrain.
struct Place {
  const Surface& surface;
  const GroundRule& rule;
  float sea_level_m;  // far below everything if there is none
  dvec2 center;       // reaches count from here
  std::span<const KeepOut> keep_out;
  std::uint32_t seed;
  const Sight* sight;  // squares where nothing matters stay empty; null: everything matters
  double tallest_m;    // no plant is taller
};

/// The layer's instances, in the order of its squares. Their models are indices into `models`,
/// which must hold all that `choose` returns. Runs on all cores; the bits do not depend on how
/// many.
std::vector<Instance> place_layer(const Layer& layer, const Place& place,
                                  std::span<const plant::ModelKey> models);

}  // namespace aerostat::scatter
