#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "bvh/bvh.hpp"
#include "core/array.hpp"
#include "instance.h"
#include "mesh/grid_mesh.hpp"
#include "trace_triangle.h"
#include "world/group.hpp"

/// Scene and meshes as the structs that the kernels read.
namespace aerostat::pack {

/// What lies beside the trees in the buffers of a frame; triangles and faces stand in the order of
/// the trees' leaves.
struct PackedArrays {
  Array<AeroTriangle> triangles;
  Array<AeroFace> faces;  // vertex indices within these arrays
  Array<AeroVertex> vertices;
};

/// The number of elements that arrays hold.
struct Room {
  std::size_t triangles = 0, vertices = 0;

  Room& operator+=(const Room& other) {
    triangles += other.triangles;
    vertices += other.vertices;
    return *this;
  }
};

/// Returns the number of elements that arrays hold.
Room room_of(const PackedArrays& arrays);

/// Makes arrays hold so many elements without being moved.
void reserve(PackedArrays& arrays, const Room& room);

/// A group as the kernels read it, without its arrays. The `order` of its trees, by which the
/// triangles were sorted, is empty.
struct PackedGroup {
  std::vector<bvh::Bvh> trees;                 // that stand in the world
  std::vector<bvh::Bvh> models;                // that instances refer to
  std::vector<AeroInstance> instances;         // `root` is the number of the model
  std::shared_ptr<const mesh::GridMesh> grid;  // that patches of a tree refer to, or null
  Room room;                                   // of the group's arrays

  bool empty() const { return trees.empty(); }
};

/// A group and its arrays: the triangles of its trees, then those of its models.
struct Packed {
  PackedGroup group;
  PackedArrays arrays;
};

/// Builds the trees of a group and sorts its triangles. The arrays get room for `more` elements
/// that are to be appended. Runs on all cores.
Packed pack_shape(const world::Shape& shape, const Room& more = {});

/// Packs objects in the same way. The materials of files that they name are counted from
/// `first_file_material` among those of all models.
Packed pack_objects(const world::Objects& objects, const Room& more,
                    std::uint32_t first_file_material = 0);

/// Appends `part` to `whole`.
void append(PackedArrays& whole, const PackedArrays& part);

/// Builds the common tree of several groups, whose arrays follow each other in the same order.
/// Throws Error{internal} if more than one of them has a height grid.
bvh::JoinedBvh join_trees(const std::vector<std::shared_ptr<const PackedGroup>>& groups);

/// Returns the instances of several groups, whose common tree is `tree`.
std::vector<AeroInstance> join_instances(
    const std::vector<std::shared_ptr<const PackedGroup>>& groups, const bvh::JoinedBvh& tree);

}  // namespace aerostat::pack
