#pragma once

#include <span>

#include "binary.hpp"
#include "bins.hpp"

namespace aerostat::bvh {

/// The builder's innermost loops, compiled for one vector width. All widths give the same bits.
struct Loops {
  /// Adds a range of primitives to the bins.
  void (*fill)(Bins& bins, const Primitive* first, std::size_t count, const BinMap& map);
  /// Finds the cheapest plane, if there is one, and the boxes of its sides.
  Plane (*search)(const Bins& bins, Box (&bounds)[2]);
  /// Reorders a range so that the primitives left of the plane come first. Returns their number,
  /// and the bounds of the centroids of both sides.
  std::size_t (*partition)(Primitive* first, std::size_t count, const BinMap& map,
                           const Plane& plane, Box (&centroids)[2]);
  /// Builds the subtree over 2 to kSmallCount primitives. Writes its nodes from `nodes` on and
  /// reorders the primitives. `depth` is the depth of its root.
  void (*build_small)(Primitive* first, int count, BinaryNode* nodes, int depth,
                      const BuildOptions& options, Forest& forest);
  /// Calls combine() of forest.hpp.
  void (*combine)(const Forest& left, const Forest& right, float half_area, std::uint32_t count,
                  const BuildOptions& options, Forest& forest, Plan& plan);
};

/// Returns the loops for the widest vectors that this processor has.
const Loops& loops();

/// Returns the loops for each vector width that this processor has. The plain loops come first.
std::span<const Loops* const> all_loops();

}  // namespace aerostat::bvh
