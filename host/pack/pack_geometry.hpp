#pragma once

#include <vector>

#include "bvh/bvh.hpp"
#include "core/array.hpp"
#include "trace_triangle.h"
#include "world/world.hpp"

/// Scene and meshes as the structs that the kernels read.
namespace aerostat::pack {

/// What lies beside the trees in the buffers of a frame; triangles and faces stand in the order of
/// the trees' leaves.
struct PackedArrays {
  Array<AeroTriangle> triangles;
  Array<AeroFace> faces;  // vertex indices within these arrays
  Array<AeroVertex> vertices;
};

/// A group of objects with its trees: one over each grid, one over all the rest.
struct PackedGroup {
  std::vector<bvh::Bvh> trees;  // `order` is given up: it is what the triangles were sorted by
  PackedArrays arrays;
};

/// Builds the trees of a group and sorts its triangles. Runs on all cores. The arrays get room for
/// as many elements more as `room` holds.
PackedGroup pack_group(const std::vector<world::Object>& objects, const PackedArrays& room = {});

/// Appends `part` to `whole`.
void append(PackedArrays& whole, const PackedArrays& part);

/// The common tree of several groups whose arrays are appended in this order; null ones are left
/// out.
bvh::Bvh join_trees(const std::vector<const PackedGroup*>& groups);

}  // namespace aerostat::pack
