#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "box.hpp"
#include "bvh.hpp"

namespace aerostat::bvh {

/// The record that the builder reorders: a triangle's box and its number.
struct Primitive {
  float lo[3];
  std::uint32_t triangle;
  float hi[3];
  std::uint32_t unused;
};

struct PrimitiveSet {
  std::unique_ptr<Primitive[]> items;
  std::uint32_t count = 0;
  Box bounds;     // bounds of the triangles
  Box centroids;  // bounds of the half centres of their boxes
  std::uint64_t non_finite = 0;
  std::uint64_t degenerate = 0;
};

/// Tells whether a triangle can be hit. It must be finite and have an area.
enum class Verdict { good, non_finite, degenerate };

Verdict judge(const vec3& a, const vec3& b, const vec3& c);

inline Bounds to_bounds(const Box& box) {
  return {{box.lo[0], box.lo[1], box.lo[2]}, {box.hi[0], box.hi[1], box.hi[2]}};
}

/// Checks the input of a build. Throws the errors that build() throws for too many triangles or
/// for a wrong size of leaves.
void check_input(std::size_t triangles, const BuildOptions& options);

/// Collects the boxes of all triangles that can be hit, in the order of the input. Throws
/// Error{internal} if a triangle names a vertex that does not exist.
PrimitiveSet collect_primitives(std::span<const vec3> positions, std::span<const uvec3> triangles);

}  // namespace aerostat::bvh
