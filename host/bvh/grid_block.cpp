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

// What one node of leaves may cover. Eight of any make a block.
constexpr std::array<Shape, 4> kShapes{{{4, 2}, {2, 4}, {8, 1}, {1, 8}}};

constexpr std::uint32_t kCorners = kBlockSide + 1;

// Twice the area of a triangle seen from above; 0 if rounding could hide that it has none.
float sure_area(Float4 a, Float4 b, Float4 c) {
  const Float4 u = b - a, v = c - a;
  const float uv = u[2] * v[0], vu = u[0] * v[2];
  const float area = std::fabs(uv - vu);
  return area > 1e-6f * (std::fabs(uv) + std::fabs(vu)) && area > 1e-30f ? area : 0.0f;
}

Float4 as_float4(const vec3& v) {
  return Float4{v.x, v.y, v.z, 0.0f};
}

std::uint32_t leaf_reference(std::uint32_t first, std::uint32_t count) {
  return AERO_BVH_LEAF | ((count - 1) << AERO_BVH_COUNT_SHIFT) | first;
}

std::uint32_t triangles_of(std::uint8_t kept) {
  return (kept & 1u) + (kept >> 1);
}

bool all_finite(const GridMesh& mesh, std::uint32_t left, std::uint32_t top, std::uint32_t width,
                std::uint32_t height) {
  Float4 sum = broadcast(0.0f);
  for (std::uint32_t j = 0; j <= height; ++j) {
    const vec3* row = &mesh.positions[std::size_t{top + j} * (mesh.columns + 1) + left];
    for (std::uint32_t i = 0; i <= width; ++i) sum += as_float4(row[i]) * 0.0f;
  }
  // Infinity and NaN times zero are NaN, which stays.
  return sum[0] == 0.0f && sum[1] == 0.0f && sum[2] == 0.0f;
}

}  // namespace

/// Some cells of a block that are to be one child of its node.
struct GridBlock::Part {
  Box box;
  std::uint32_t cells[AERO_BVH_WIDTH];
  int count = 0;  // of cells that have triangles
};

GridBlock::GridBlock(const GridMesh& mesh, std::uint32_t number)
    : columns_(mesh.columns),
      left_(number % mesh.block_columns() * kBlockSide),
      top_(number / mesh.block_columns() * kBlockSide),
      width_(std::min(kBlockSide, mesh.columns - left_)),
      height_(std::min(kBlockSide, mesh.rows - top_)) {
  const bool finite = all_finite(mesh, left_, top_, width_, height_);
  for (std::uint32_t j = 0; j < height_; ++j) {
    for (std::uint32_t i = 0; i < width_; ++i) add_cell(mesh, i, j, finite);
  }
}

void GridBlock::add_cell(const GridMesh& mesh, std::uint32_t i, std::uint32_t j, bool finite) {
  const std::size_t at = std::size_t{top_ + j} * (columns_ + 1) + left_ + i;
  const std::size_t corners[4] = {at, at + 1, at + columns_ + 1, at + columns_ + 2};
  const uvec3* triangles = &mesh.triangles[first_triangle(i, j)];
  const std::uint32_t cell = j * kBlockSide + i;
  for (unsigned k = 0; k < 2; ++k) {
    const uvec3 t = triangles[k];
    for (int c = 0; c < 3; ++c) {
      const std::size_t v = static_cast<std::size_t>(t[c]);
      if (v == corners[0] || v == corners[1] || v == corners[2] || v == corners[3]) continue;
      throw Error(ErrorKind::internal, "building a BVH: triangle " +
                                           std::to_string(first_triangle(i, j) + k) +
                                           " has a corner that is not one of its grid cell");
    }
    const vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
    const Float4 fa = as_float4(a), fb = as_float4(b), fc = as_float4(c);
    if (!finite || sure_area(fa, fb, fc) == 0.0f) {
      const Verdict verdict = judge(a, b, c);
      non_finite_ += verdict == Verdict::non_finite ? 1 : 0;
      degenerate_ += verdict == Verdict::degenerate ? 1 : 0;
      if (verdict != Verdict::good) continue;
    }
    kept_[cell] = static_cast<std::uint8_t>(kept_[cell] | 1u << k);
    for (const Float4 p : {fa, fb, fc}) boxes_[cell].grow(p);
  }
  bounds_.grow(boxes_[cell]);
}

std::uint32_t GridBlock::first_triangle(std::uint32_t i, std::uint32_t j) const {
  return 2 * ((top_ + j) * columns_ + left_ + i);
}

GridBlock::Part GridBlock::part(std::uint32_t i0, std::uint32_t j0, std::uint32_t width,
                                std::uint32_t height) const {
  Part result;
  const std::uint32_t i1 = std::min(i0 + width, width_), j1 = std::min(j0 + height, height_);
  for (std::uint32_t j = j0; j < j1; ++j) {
    for (std::uint32_t i = i0; i < i1; ++i) {
      const std::uint32_t cell = j * kBlockSide + i;
      if (kept_[cell] == 0) continue;
      result.cells[result.count++] = cell;
      result.box.grow(boxes_[cell]);
    }
  }
  return result;
}

int GridBlock::parts_of(unsigned shape, Part* parts) const {
  const Shape s = kShapes[shape];
  int count = 0;
  for (std::uint32_t j = 0; j < height_; j += s.height) {
    for (std::uint32_t i = 0; i < width_; i += s.width) {
      parts[count] = part(i, j, s.width, s.height);
      if (parts[count].count > 0) ++count;
    }
  }
  return count;
}

BlockPlan GridBlock::plan() const {
  BlockPlan best;
  float least = kInfinity;
  for (unsigned shape = 0; shape < kShapes.size(); ++shape) {
    Part parts[AERO_BVH_WIDTH];
    const int count = parts_of(shape, parts);
    int nodes = count > 1 ? 1 : 0;
    float area = 0.0f;
    for (int p = 0; p < count; ++p) {
      if (parts[p].count > 1) ++nodes;
      area += parts[p].box.half_area();
    }
    if (area >= least && shape > 0) continue;
    least = area;
    best.shape = static_cast<std::uint8_t>(shape);
    best.nodes = static_cast<std::uint8_t>(nodes);
  }
  for (const std::uint8_t kept : kept_)
    best.triangles = static_cast<std::uint16_t>(best.triangles + triangles_of(kept));
  return best;
}

std::uint32_t GridBlock::emit(const BlockPlan& plan, AeroBvhNode* nodes, std::uint32_t first_node,
                              std::uint32_t* order, std::uint32_t first_slot) const {
  Part parts[AERO_BVH_WIDTH];
  const int count = parts_of(plan.shape, parts);
  std::uint32_t next_node = first_node + (count > 1 ? 1 : 0);
  std::uint32_t reference = AERO_BVH_EMPTY;
  if (count > 1) nodes[first_node] = empty_node();
  const auto leaf = [&](std::uint32_t cell) {
    const std::uint32_t begin = first_slot;
    const std::uint32_t triangle = first_triangle(cell % kBlockSide, cell / kBlockSide);
    if ((kept_[cell] & 1u) != 0) order[first_slot++] = triangle;
    if ((kept_[cell] & 2u) != 0) order[first_slot++] = triangle + 1;
    return leaf_reference(begin, first_slot - begin);
  };
  for (int p = 0; p < count; ++p) {
    const Part& part = parts[p];
    if (part.count == 1) {
      reference = leaf(part.cells[0]);
    } else {
      reference = next_node++;
      nodes[reference] = empty_node();
      for (int c = 0; c < part.count; ++c)
        set_child(nodes[reference], c, to_bounds(boxes_[part.cells[c]]), leaf(part.cells[c]));
    }
    if (count > 1) set_child(nodes[first_node], p, to_bounds(part.box), reference);
  }
  return count > 1 ? first_node : reference;
}

}  // namespace aerostat::bvh
