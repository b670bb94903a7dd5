#pragma once

#include <cstdint>
#include <span>

#include "bvh.hpp"

namespace aerostat::bvh {

/// The tree of a mesh that is a grid of columns x rows cells, such as a terrain, in linear time and
/// without memory beside the result. Vertex (i, j) is positions[j * (columns + 1) + i]; cell (i, j)
/// has the triangles 2 * (j * columns + i) and the one after, whose corners are corners of the
/// cell. Cells may have any shape; positions beyond the grid's are not used. Leaves hold one cell,
/// blocks of 8 x 8 cells become two levels of nodes, and a tree by the surface area heuristic
/// stands over the blocks.
/// The result is as that of build(): what cannot be hit is dropped and counted, and it does not
/// depend on the number of threads. Throws Error{internal} if the mesh is no such grid or
/// options.max_leaf_triangles < 2, Error{bad_data} as build() does.
Bvh build_grid(std::span<const vec3> positions, std::span<const uvec3> triangles,
               std::uint32_t columns, std::uint32_t rows, const BuildOptions& options = {});

}  // namespace aerostat::bvh
