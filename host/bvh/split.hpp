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

/// Splits by binned surface area heuristic (Wald, "On fast construction of SAH-based bounding
/// volume hierarchies", 2007): reorders the range so that the left part comes first. Ranges of many
/// primitives use all cores; the result does not depend on how many. Empty if no plane between bins
/// parts the centroids (all equal, or spread beyond what floats can measure).
std::optional<Parts> split_binned(std::span<Primitive> range, const Box& centroids);

/// Splits into halves by centroid along the widest axis; the fallback that always works. Two
/// primitives at least.
Parts split_halves(std::span<Primitive> range, const Box& centroids);

}  // namespace aerostat::bvh
