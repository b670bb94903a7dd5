#pragma once

#include <optional>
#include <span>

#include "primitive.hpp"

namespace aerostat::bvh {

/// The two sides of a split of a range of primitives.
struct Parts {
  std::uint32_t left_count = 0;
  Box bounds[2];
  Box centroids[2];
};

/// Splits a range by the binned surface area heuristic (Wald, "On fast construction of SAH-based
/// bounding volume hierarchies", 2007). The range is reordered so that the left part comes first.
/// Ranges of many primitives use all cores, and the result does not depend on their number.
/// Returns nothing if no plane between bins parts the centroids, because they are all equal or
/// spread beyond the range of floats.
std::optional<Parts> split_binned(std::span<Primitive> range, const Box& centroids);

/// Splits a range into halves by centroid along the widest axis. This is the fallback that always
/// works. The range must have at least two primitives.
Parts split_halves(std::span<Primitive> range, const Box& centroids);

}  // namespace aerostat::bvh
