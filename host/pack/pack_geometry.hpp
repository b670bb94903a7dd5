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

/// Objects with their trees: one over the ground, if there is one, and one over all the rest.
struct PackedGroup {
  std::vector<bvh::Bvh> trees;  // `order` is given up: it is what the triangles were sorted by
  PackedArrays arrays;
};

/// Builds the tree of meshes and sorts their triangles. Runs on all cores.
PackedGroup pack_objects(const world::Objects& objects);

/// The same with the tree of the ground, which the kernels read as it is. The arrays get room for
/// as many elements more as `room` holds.
PackedGroup pack_land(const world::Land& land, const PackedArrays& room = {});

/// Appends `part` to `whole`.
void append(PackedArrays& whole, const PackedArrays& part);

/// The common tree of several groups whose arrays are appended in this order; null ones are left
/// out.
bvh::Bvh join_trees(const std::vector<const PackedGroup*>& groups);

}  // namespace aerostat::pack
