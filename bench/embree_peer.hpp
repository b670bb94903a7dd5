#pragma once

#include <memory>
#include <vector>

#include "device_bench.hpp"

namespace aerostat::bench {

/// The hint that Embree is given about the rays of a packet.
enum class Coherence { coherent, incoherent };

/// Embree on the same triangles, the same plants as instances and the same rays, on all cores.
class EmbreePeer {
 public:
  explicit EmbreePeer(const render::HostGeometry& geometry);
  ~EmbreePeer();

  /// Returns the seconds of building the trees of scene and plants at Embree's default quality.
  double commit_seconds() const { return commit_seconds_; }
  /// Returns the seconds of building another tree over one mesh.
  double time_commit(const mesh::TriangleMesh& mesh) const;

  double time_closest_1(const RaySet& rays) const;
  double time_occluded_1(const RaySet& rays) const;
  /// These functions need rays in packets of 4, 8 or 16, and ask Embree for packets of as many.
  double time_closest_packets(const RaySet& rays, Coherence coherence) const;
  double time_occluded_packets(const RaySet& rays, Coherence coherence) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
  double commit_seconds_ = 0.0;
};

}  // namespace aerostat::bench
