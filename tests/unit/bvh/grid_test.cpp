#include "bvh/grid.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/error.hpp"
#include "inspect.hpp"
#include "support/bvh_meshes.hpp"

namespace aerostat {
namespace {

using bvh::Bvh;

struct Size {
  std::uint32_t columns, rows;
};

void PrintTo(const Size& size, std::ostream* out) {
  *out << size.columns << " x " << size.rows;
}

// Returns a bumpy grid over [-1, 1]^2 whose lines are farther apart towards the border.
mesh::GridMesh grid(const Size& size, float height = 0.3f) {
  mesh::GridMesh mesh(test::grid_lines(size.columns), test::grid_lines(size.rows));
  for (std::uint32_t j = 0; j <= size.rows; ++j) {
    for (std::uint32_t i = 0; i <= size.columns; ++i) {
      const float x = mesh.x(i), z = mesh.z(j);
      const float y = std::sin(5.0f * x) * std::cos(4.0f * z) + 0.2f * std::sin(31.0f * x * z);
      mesh.set(i, j, height * y, vec3(0.0f, 1.0f, 0.0f));
    }
  }
  return mesh;
}

/// Traverses the tree of a grid by nothing but the definitions in bvh_node.h.
class GridInspector {
 public:
  GridInspector(const Bvh& tree, const mesh::GridMesh& mesh)
      : tree_(tree), mesh_(mesh), seen_(std::size_t{mesh.columns()} * mesh.rows()) {
    visit(0, tree.bounds);
  }

  bool every_cell_once() const {
    return std::all_of(seen_.begin(), seen_.end(), [](int n) { return n == 1; });
  }

  std::uint32_t nodes = 0;
  /// Tells whether all bounds contain their content and all references are valid.
  bool sound = true;

 private:
  void visit(std::uint32_t index, const bvh::Bounds& bounds) {
    ++nodes;
    const AeroBvhNode& node = tree_.nodes.at(index);
    for (int i = 0; i < AERO_BVH_WIDTH; ++i) {
      const aero_uint child = node.child[i];
      if (child == AERO_BVH_EMPTY) continue;
      const bvh::Bounds box = test::child_bounds(node, i);
      sound &= test::contains(bounds, box.lo) && test::contains(bounds, box.hi);
      if ((child & AERO_BVH_LEAF) == 0) {
        visit(child, box);
      } else {
        sound &= (child & AERO_BVH_PATCH) != 0;
        visit_patch(child, box);
      }
    }
  }

  void visit_patch(aero_uint child, const bvh::Bounds& box) {
    const aero_uint shape = child >> AERO_PATCH_SHAPE_SHIFT & AERO_PATCH_SHAPE_MASK;
    const aero_uint i0 = child & AERO_PATCH_CELL_MASK;
    const aero_uint j0 = child >> AERO_PATCH_ROW_SHIFT & AERO_PATCH_CELL_MASK;
    sound &= shape <= AERO_PATCH_DEEP;
    const aero_uint width = shape == AERO_PATCH_WIDE ? 4 : 2;
    for (aero_uint j = j0; j < std::min(j0 + 8 / width, mesh_.rows()); ++j) {
      for (aero_uint i = i0; i < std::min(i0 + width, mesh_.columns()); ++i) {
        ++seen_[std::size_t{j} * mesh_.columns() + i];
        for (aero_uint k = 0; k < 4; ++k)
          sound &= test::contains(box, mesh_.position(i + k % 2, j + k / 2));
      }
    }
  }

  const Bvh& tree_;
  const mesh::GridMesh& mesh_;
  std::vector<int> seen_;
};

class BvhGrid : public testing::TestWithParam<Size> {};

TEST_P(BvhGrid, HoldsEveryCellOnceWithinItsBoxes) {
  const mesh::GridMesh mesh = grid(GetParam());
  const Bvh tree = bvh::build_grid(mesh);
  const GridInspector seen(tree, mesh);
  EXPECT_TRUE(seen.sound);
  EXPECT_TRUE(seen.every_cell_once());
  EXPECT_EQ(seen.nodes, tree.nodes.size());
  EXPECT_EQ(tree.stats.nodes, tree.nodes.size());
  EXPECT_EQ(tree.stats.input_triangles, mesh.triangles());
  EXPECT_EQ(tree.stats.leaves, mesh.triangles() / 2);
  EXPECT_EQ(tree.slots, 0u);
  EXPECT_LE(tree.stats.stack_entries, static_cast<std::uint32_t>(bvh::kStackBudget));
}

INSTANTIATE_TEST_SUITE_P(Sizes, BvhGrid,
                         testing::Values(Size{1, 1}, Size{1, 2}, Size{2, 1}, Size{3, 3}, Size{1, 9},
                                         Size{7, 8}, Size{8, 8}, Size{9, 8}, Size{8, 9},
                                         Size{1, 200}, Size{33, 17}, Size{37, 31}, Size{100, 100},
                                         Size{64, 256}, Size{255, 257}, Size{1000, 1000}),
                         [](const auto& test) {
                           return std::to_string(test.param.columns) + "x" +
                                  std::to_string(test.param.rows);
                         });

TEST(BvhGridBuild, GivesTheSameTreeOnAnyNumberOfThreads) {
  const mesh::GridMesh mesh = grid({500, 300});
  const Bvh first = bvh::build_grid(mesh);
  for (const std::size_t threads : {1, 7}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_TRUE(test::same_bytes(first, bvh::build_grid(mesh)));
  }
}

TEST(BvhGridBuild, CostsHardlyMoreThanTheGeneralBuild) {
  // A general tree would cut some blocks at cliffs elsewhere.
  for (const auto& [height, limit] : {std::pair(0.01f, 1.1), {0.3f, 1.1}, {3.0f, 1.25}}) {
    const mesh::GridMesh mesh = grid({256, 256}, height);
    const mesh::TriangleMesh soup = mesh::to_triangles(mesh);
    const double own = bvh::build_grid(mesh).stats.sah_cost;
    const double general = bvh::build(soup.positions, soup.triangles).stats.sah_cost;
    EXPECT_LT(own, limit * general) << "heights up to " << height;
    EXPECT_GT(own, 0.8 * general) << "heights up to " << height;
  }
}

TEST(BvhGridBuild, RefusesHeightsThatAreNotFinite) {
  mesh::GridMesh mesh = grid({20, 20});
  mesh.set(7, 9, std::nanf(""), vec3(0.0f, 1.0f, 0.0f));
  EXPECT_THROW(bvh::build_grid(mesh), Error);
}

TEST(BvhGridBuild, JoinsWithATreeOfSlots) {
  const mesh::GridMesh mesh = grid({40, 24});
  const test::Soup soup = test::sphere(12);
  const Bvh ground = bvh::build_grid(mesh), ball = bvh::build(soup.positions, soup.triangles);
  const bvh::Part parts[] = {{&ground}, {&ball}};
  const Bvh joined = bvh::join(parts);
  EXPECT_EQ(joined.slots, ball.slots);
  EXPECT_EQ(joined.order, ball.order);
  const auto patches = [](const Bvh& tree) {
    std::vector<aero_uint> found;
    for (const AeroBvhNode& node : tree.nodes) {
      for (const aero_uint child : node.child) {
        if (child != AERO_BVH_EMPTY && child >> 30 == 3) found.push_back(child);
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  };
  EXPECT_EQ(patches(joined), patches(ground));
}

}  // namespace
}  // namespace aerostat
