#pragma once

#include <span>

#include "binary.hpp"
#include "bins.hpp"

namespace aerostat::bvh {

/// The builder's innermost loops, compiled for one width of vectors. All widths give the same bits.
struct Loops {
  /// Adds a range of primitives to the bins.
  void (*fill)(Bins& bins, const Primitive* first, std::size_t count, const BinMap& map);
  /// The cheapest plane, if there is one, and the boxes of its sides.
  Plane (*search)(const Bins& bins, Box (&bounds)[2]);
  /// Reorders a range so that what is left of the plane comes first, and returns how many that are
  /// and the bounds of both sides' centroids.
  std::size_t (*partition)(Primitive* first, std::size_t count, const BinMap& map,
                           const Plane& plane, Box (&centroids)[2]);
  /// Builds the subtree over 2 to kSmallCount primitives: writes its nodes from `nodes` on and
  /// reorders the primitives. `depth` is that of its root.
  void (*build_small)(Primitive* first, int count, BinaryNode* nodes, int depth,
                      const BuildOptions& options, Forest& forest);
  /// combine() of forest.hpp.
  void (*combine)(const Forest& left, const Forest& right, float half_area, std::uint32_t count,
                  const BuildOptions& options, Forest& forest, Plan& plan);
};

/// For the widest vectors that this processor has.
const Loops& loops();

/// For each width that this processor has, the plain one first.
std::span<const Loops* const> all_loops();

}  // namespace aerostat::bvh
