#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "box.hpp"
#include "bvh.hpp"

namespace aerostat::bvh {

/// Cells of a block along a side: two levels of full wide nodes over one leaf per cell.
inline constexpr std::uint32_t kBlockSide = 8;
inline constexpr std::uint32_t kBlockCells = kBlockSide * kBlockSide;

/// Stack entries that a block needs at most as a wide node.
inline constexpr int kBlockStack = 2 * AERO_BVH_WIDTH - 1;

/// A mesh that is a grid of cells; see build_grid.
struct GridMesh {
  std::span<const vec3> positions;
  std::span<const uvec3> triangles;
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;

  std::uint32_t block_columns() const { return (columns + kBlockSide - 1) / kBlockSide; }
  std::uint32_t block_rows() const { return (rows + kBlockSide - 1) / kBlockSide; }
};

/// How a block is covered by nodes, and what that takes.
struct BlockPlan {
  std::uint8_t shape = 0;
  std::uint8_t nodes = 0;
  std::uint16_t triangles = 0;  // 0: the block is empty
};

/// Up to 8 x 8 cells of a grid: their boxes and which of their triangles can be hit.
class GridBlock {
 public:
  /// Throws Error{internal} if a triangle has a corner outside its cell.
  GridBlock(const GridMesh& mesh, std::uint32_t number);

  const Box& bounds() const { return bounds_; }
  std::uint32_t non_finite() const { return non_finite_; }
  std::uint32_t degenerate() const { return degenerate_; }

  /// The cover of least surface area.
  BlockPlan plan() const;

  /// Writes the nodes of the plan from nodes[first_node] on and the numbers of the triangles from
  /// order[first_slot] on. Returns the reference to the whole block.
  std::uint32_t emit(const BlockPlan& plan, AeroBvhNode* nodes, std::uint32_t first_node,
                     std::uint32_t* order, std::uint32_t first_slot) const;

 private:
  struct Part;

  std::uint32_t first_triangle(std::uint32_t i, std::uint32_t j) const;
  void add_cell(const GridMesh& mesh, std::uint32_t i, std::uint32_t j, bool finite);
  int parts_of(unsigned shape, Part* parts) const;
  Part part(std::uint32_t i, std::uint32_t j, std::uint32_t width, std::uint32_t height) const;

  std::uint32_t columns_ = 0;             // of the grid
  std::uint32_t left_ = 0, top_ = 0;      // the block's first cell
  std::uint32_t width_ = 0, height_ = 0;  // cells
  std::array<Box, kBlockCells> boxes_;
  std::array<std::uint8_t, kBlockCells> kept_{};  // bit k: triangle k of the cell
  Box bounds_;
  std::uint32_t non_finite_ = 0, degenerate_ = 0;
};

}  // namespace aerostat::bvh
