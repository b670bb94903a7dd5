#pragma once

#include <tbb/enumerable_thread_specific.h>

#include "drainage.hpp"
#include "rimmed_grid.hpp"

namespace aerostat::terrain {

/// What the ground under a grid is made of, by node.
struct RimmedRock {
  Rimmed<float> uplift, steepest;
  Rimmed<std::uint8_t> outlets;  // 1 or 0
};

/// A node of a stream system.
struct StreamNode {
  int place;
  int receiver;      // its number in the system
  float length;      // of the way to it, metres
  float discharge;   // m^2 of catchment, weighted by uplift
  float floor;       // half width of the valley's floor, 0 if it has none
  float remoteness;  // metres from the floor's river, along the stream
  float height;
};

/// A round of erosion: from every node whose water goes nowhere upwards, along the streams, each
/// node is put above its receiver by the slope that the water from its catchment keeps, at most the
/// rock's. `directions` are those of receivers.hpp and form no ring. Each stream system is worked
/// out by itself, on all cores; the bits do not depend on how many.
class Erosion {
 public:
  Erosion(const DrainageOptions& options, const RimmedGrid& grid, const RimmedRock& rock)
      : options_(options), grid_(grid), rock_(rock) {}

  /// Water from side streams adds up in the order of `ranks`, last first, or of the heights if
  /// there are none.
  void raise(const Rimmed<std::uint8_t>& directions, const Rimmed<int>* ranks, float strength,
             Rimmed<float>& heights);

 private:
  const DrainageOptions& options_;
  const RimmedGrid& grid_;
  const RimmedRock& rock_;
  tbb::enumerable_thread_specific<std::vector<StreamNode>> rooms_;
};

}  // namespace aerostat::terrain
