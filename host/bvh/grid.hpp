#pragma once

#include "bvh.hpp"
#include "mesh/grid_mesh.hpp"

namespace aerostat::bvh {

/// Builds the tree of a height grid in linear time. Its leaves are patches of eight cells, whose
/// boxes the kernels compute from the heights. Eight patches make a block of 8 x 8 cells, which
/// is one node. A tree by the surface area heuristic stands over the blocks. The result has no
/// slots (`order` is empty) and does not depend on the number of threads. Throws Error{bad_data}
/// if a height is not finite.
Bvh build_grid(const mesh::GridMesh& grid, const BuildOptions& options = {});

}  // namespace aerostat::bvh
