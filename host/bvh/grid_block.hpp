#pragma once

#include <array>
#include <cstdint>

#include "box.hpp"
#include "bvh.hpp"
#include "mesh/grid_mesh.hpp"
#include "slopes.hpp"

namespace aerostat::bvh {

/// The number of cells along a side of a block. Blocks at the far rims may have fewer cells.
inline constexpr std::uint32_t kBlockSide = 8;

/// The way in which a block is cut into patches.
struct BlockPlan {
  std::uint32_t shape = 0;    // value of AERO_PATCH_...
  std::uint32_t patches = 0;  // number of patches that hold a cell
  float patch_area = 0.0f;    // sum of the half surface areas of the patches
  /// The sum of the half surface areas of the cells.
  float cell_area = 0.0f;
};

/// The boxes of a block's cells, from which its patches and its node are made.
class GridBlock {
 public:
  /// Reads the block whose first cell is (i, j). Throws Error{bad_data} if a height is not
  /// finite.
  GridBlock(const mesh::GridMesh& grid, std::uint32_t i, std::uint32_t j);

  const Box& bounds() const { return bounds_; }

  /// Returns the cut whose patches have the least surface area.
  BlockPlan plan() const;

  /// Returns the node over the patches of a cut.
  AeroBvhNode node(const BlockPlan& plan) const;

 private:
  Box patch(std::uint32_t shape, std::uint32_t number) const;
  Slopes patch_slopes(std::uint32_t shape, std::uint32_t number) const;

  const mesh::GridMesh& grid_;
  std::uint32_t i_, j_;
  std::array<std::array<Box, kBlockSide>, kBlockSide>
      cells_;  // [row][column]; empty beyond the rim
  Box bounds_;
};

}  // namespace aerostat::bvh
