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

/// Elements that are to be appended later.
struct Room {
  std::size_t triangles = 0, vertices = 0;

  Room operator+(const Room& other) const {
    return {triangles + other.triangles, vertices + other.vertices};
  }
};

/// The same with the tree of the ground, which the kernels read as it is. The arrays get `room`.
PackedGroup pack_land(const world::Land& land, const Room& room = {});

/// Appends `part` to `whole`.
void append(PackedArrays& whole, const PackedArrays& part);

struct PackedPlants;

/// The common tree of several groups, whose arrays are appended in this order and followed by those
/// of the plants; null ones are left out.
bvh::JoinedBvh join_trees(const std::vector<const PackedGroup*>& groups,
                          const PackedPlants* plants);

}  // namespace aerostat::pack
