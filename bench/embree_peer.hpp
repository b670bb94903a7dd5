#pragma once

#include <memory>

#include "device_bench.hpp"

namespace aerostat::bench {

/// Embree on the same triangles and the same rays, on all cores.
class EmbreePeer {
 public:
  explicit EmbreePeer(const render::HostGeometry& geometry);
  ~EmbreePeer();

  double commit_seconds() const { return commit_seconds_; }

  double time_closest_1(const RaySet& rays) const;
  double time_occluded_1(const RaySet& rays) const;
  /// Packets of 16 with the coherent flag; the rays must come in packets of 16.
  double time_closest_16(const RaySet& rays) const;
  double time_occluded_16(const RaySet& rays) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
  double commit_seconds_ = 0.0;
};

}  // namespace aerostat::bench
