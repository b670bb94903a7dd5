#include "grid_block.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "collapse.hpp"
#include "core/error.hpp"
#include "primitive.hpp"

namespace aerostat::bvh {
namespace {

struct Shape {
  std::uint32_t width, height;
};

/// The cells that a patch of each shape covers, indexed by AERO_PATCH_...
constexpr std::array<Shape, 2> kShapes{{{4, 2}, {2, 4}}};

/// The first cell of a patch within its block.
struct Corner {
  std::uint32_t i, j;
};

Corner corner_of(std::uint32_t shape, std::uint32_t number) {
  const Shape s = kShapes[shape];
  const std::uint32_t across = kBlockSide / s.width;
  return {number % across * s.width, number / across * s.height};
}

}  // namespace

GridBlock::GridBlock(const mesh::GridMesh& grid, std::uint32_t i, std::uint32_t j)
    : grid_(grid), i_(i), j_(j) {
  const std::uint32_t width = std::min(kBlockSide, grid.columns() - i);
  const std::uint32_t height = std::min(kBlockSide, grid.rows() - j);
  float heights[kBlockSide + 1][kBlockSide + 1];
  for (std::uint32_t row = 0; row <= height; ++row) {
    for (std::uint32_t column = 0; column <= width; ++column) {
      const float y = heights[row][column] = grid.height(i + column, j + row);
      if (!std::isfinite(y))
        throw Error(ErrorKind::bad_data, "building a BVH: the height of vertex " +
                                             std::to_string(i + column) + ", " +
                                             std::to_string(j + row) + " is not finite");
    }
  }
  for (std::uint32_t r = 0; r < height; ++r) {
    for (std::uint32_t c = 0; c < width; ++c) {
      const float a = heights[r][c], b = heights[r][c + 1];
      const float d = heights[r + 1][c], e = heights[r + 1][c + 1];
      Box& cell = cells_[r][c];
      cell.lo =
          Float4{grid.x(i + c), std::min(std::min(a, b), std::min(d, e)), grid.z(j + r), 0.0f};
      cell.hi = Float4{grid.x(i + c + 1), std::max(std::max(a, b), std::max(d, e)),
                       grid.z(j + r + 1), 0.0f};
      bounds_.grow(cell);
    }
  }
}

Box GridBlock::patch(std::uint32_t shape, std::uint32_t number) const {
  const Corner at = corner_of(shape, number);
  Box box;
  for (std::uint32_t j = at.j; j < at.j + kShapes[shape].height; ++j) {
    for (std::uint32_t i = at.i; i < at.i + kShapes[shape].width; ++i) box.grow(cells_[j][i]);
  }
  return box;
}

Slopes GridBlock::patch_slopes(std::uint32_t shape, std::uint32_t number) const {
  const Corner at = corner_of(shape, number);
  const std::uint32_t end_i = std::min(i_ + at.i + kShapes[shape].width, grid_.columns());
  const std::uint32_t end_j = std::min(j_ + at.j + kShapes[shape].height, grid_.rows());
  Slopes slopes;
  for (std::uint32_t j = j_ + at.j; j < end_j; ++j) {
    for (std::uint32_t i = i_ + at.i; i < end_i; ++i) {
      slopes.grow(grid_.height(i, j), grid_.height(i + 1, j), grid_.height(i, j + 1),
                  grid_.height(i + 1, j + 1), grid_.x(i + 1) - grid_.x(i),
                  grid_.z(j + 1) - grid_.z(j));
    }
  }
  return slopes;
}

BlockPlan GridBlock::plan() const {
  BlockPlan best;
  for (std::uint32_t shape = 0; shape < kShapes.size(); ++shape) {
    BlockPlan plan{shape, 0, 0.0f, 0.0f};
    for (std::uint32_t number = 0; number < AERO_BVH_WIDTH; ++number) {
      const Box box = patch(shape, number);
      if (box.lo[0] > box.hi[0]) continue;
      ++plan.patches;
      plan.patch_area += box.half_area();
    }
    if (shape == 0 || plan.patch_area < best.patch_area) best = plan;
  }
  for (const auto& row : cells_) {
    for (const Box& cell : row) best.cell_area += cell.lo[0] > cell.hi[0] ? 0.0f : cell.half_area();
  }
  return best;
}

AeroBvhNode GridBlock::node(const BlockPlan& plan) const {
  AeroBvhNode node = empty_node();
  int slot = 0;
  for (std::uint32_t number = 0; number < AERO_BVH_WIDTH; ++number) {
    const Box box = patch(plan.shape, number);
    if (box.lo[0] > box.hi[0]) continue;
    const Corner at = corner_of(plan.shape, number);
    const Slopes slopes = patch_slopes(plan.shape, number);
    if (slopes.known()) node.slope[slot] = slopes.packed();
    set_child(node, slot++, to_bounds(box),
              AERO_BVH_LEAF | AERO_BVH_PATCH | plan.shape << AERO_PATCH_SHAPE_SHIFT |
                  (j_ + at.j) << AERO_PATCH_ROW_SHIFT | (i_ + at.i));
  }
  return node;
}

}  // namespace aerostat::bvh
