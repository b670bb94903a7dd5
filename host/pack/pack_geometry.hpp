#pragma once

#include <vector>

#include "bvh/bvh.hpp"
#include "trace_triangle.h"
#include "world/world.hpp"

/// Scene and meshes as the structs that the kernels read.
namespace aerostat::pack {

/// A group of objects with its tree; triangles and faces stand in the order of the tree's leaves.
struct PackedGroup {
  bvh::Bvh tree;  // `order` is given up: it is what the triangles were sorted by
  std::vector<AeroTriangle> triangles;
  std::vector<AeroFace> faces;  // vertex indices within this group
  std::vector<AeroVertex> vertices;

  std::uint64_t bytes() const;
};

/// Builds the tree of a group and sorts its triangles. Runs on all cores.
PackedGroup pack_group(const std::vector<world::Object>& objects);

/// Several groups as one: the buffers of a frame.
struct PackedGeometry {
  std::vector<AeroBvhNode> nodes;
  std::vector<AeroTriangle> triangles;
  std::vector<AeroFace> faces;
  std::vector<AeroVertex> vertices;
  bvh::BuildStats tree;
};

/// Joins groups; null and empty ones are left out.
PackedGeometry join_groups(const std::vector<const PackedGroup*>& groups);

}  // namespace aerostat::pack
