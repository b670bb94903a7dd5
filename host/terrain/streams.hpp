#pragma once

#include <tbb/enumerable_thread_specific.h>

#include "drainage.hpp"
#include "rimmed_grid.hpp"

namespace aerostat::terrain {

/// The properties of the ground under a grid, for each node.
struct RimmedRock {
  Rimmed<float> uplift, steepest;
  Rimmed<std::uint8_t> outlets;  // 1 for an outlet, else 0
};

/// A node of a stream system.
struct StreamNode {
  int place;
  int receiver;      // number of the receiver in the system
  float length;      // distance to the receiver in metres
  float discharge;   // catchment in m^2, weighted by uplift
  float floor;       // half width of the valley's floor in metres, 0 if it has none
  float remoteness;  // metres from the floor's river, along the stream
  float height;
};

/// A round of erosion. It goes upwards along the streams from every node whose water runs to no
/// other node. Each node is put above its receiver by the slope that the water from its catchment
/// keeps, which is at most the slope that the rock bears. Each stream system is computed on its
/// own, on all cores, and the bits do not depend on their number.
class Erosion {
 public:
  Erosion(const DrainageOptions& options, const RimmedGrid& grid, const RimmedRock& rock)
      : options_(options), grid_(grid), rock_(rock) {}

  /// Raises the heights. `directions` are those of receivers.hpp and must form no ring. Water
  /// from side streams is added in the order of `ranks`, last first, or in the order of the
  /// heights if `ranks` is null.
  void raise(const Rimmed<std::uint8_t>& directions, const Rimmed<int>* ranks, float strength,
             Rimmed<float>& heights);

 private:
  const DrainageOptions& options_;
  const RimmedGrid& grid_;
  const RimmedRock& rock_;
  tbb::enumerable_thread_specific<std::vector<StreamNode>> rooms_;
};

}  // namespace aerostat::terrain
