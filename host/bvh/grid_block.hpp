#pragma once

#include <array>
#include <cstdint>

#include "box.hpp"
#include "bvh.hpp"
#include "mesh/grid_mesh.hpp"
#include "slopes.hpp"

namespace aerostat::bvh {

/// Blocks of a grid: 8 x 8 cells each, those at the far rims perhaps fewer.
inline constexpr std::uint32_t kBlockSide = 8;

/// How a block is cut into patches.
struct BlockPlan {
  std::uint32_t shape = 0;    // AERO_PATCH_...
  std::uint32_t patches = 0;  // that hold a cell
  float patch_area = 0.0f;    // sums of half surface areas
  float cell_area = 0.0f;
};

/// The boxes of a block's cells and what can be made of them.
class GridBlock {
 public:
  /// The block whose first cell is (i, j). Throws Error{bad_data} if a height is not finite.
  GridBlock(const mesh::GridMesh& grid, std::uint32_t i, std::uint32_t j);

  const Box& bounds() const { return bounds_; }

  /// The cut of least surface area.
  BlockPlan plan() const;

  /// The node over the patches of a cut.
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
