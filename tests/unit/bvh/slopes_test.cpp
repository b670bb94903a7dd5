#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "bvh/grid.hpp"
#include "bvh/instances.hpp"
#include "inspect.hpp"
#include "support/bvh_meshes.hpp"

namespace aerostat {
namespace {

using bvh::Bvh;

/// The range of the rise for each metre along x or z.
struct Range {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();

  void grow(double slope) {
    lo = std::min(lo, slope);
    hi = std::max(hi, slope);
  }
  void grow(const Range& other) {
    lo = std::min(lo, other.lo);
    hi = std::max(hi, other.hi);
  }
  double steepest() const { return std::max(std::fabs(lo), std::fabs(hi)); }
};

using Ground = std::array<Range, 2>;

constexpr double kStep = 1.0 / AERO_SLOPE_STEPS;
// The steepest slope that bytes can hold, reduced and increased by the steps that rounding may
// take.
constexpr double kSurelyKnown = (AERO_SLOPE_ZERO - 3.0) * kStep;
constexpr double kSurelyUnknown = (AERO_SLOPE_ZERO - 1.0) * kStep;

Range told(aero_uint slope, int axis) {
  const auto value = [&](int byte) {
    return (static_cast<double>(slope >> 8 * byte & 0xffu) - AERO_SLOPE_ZERO) * kStep;
  };
  return {value(2 * axis), value(2 * axis + 1)};
}

/// Traverses the tree of a grid and compares the slopes in its nodes with the cells below them.
class SlopeInspector {
 public:
  SlopeInspector(const Bvh& tree, const mesh::GridMesh& mesh) : tree_(tree), mesh_(mesh) {
    visit(0);
  }

  int known = 0, unknown = 0;
  /// The number of children below which a slope is outside of the range in the node.
  int wrong = 0;
  /// The number of children whose range is wider than rounding needs.
  int loose = 0;
  /// The number of children without a range, although no slope below them is steep.
  int missing = 0;

 private:
  Ground visit(std::uint32_t index) {
    Ground all;
    const AeroBvhNode& node = tree_.nodes.at(index);
    for (int i = 0; i < AERO_BVH_WIDTH; ++i) {
      if (node.child[i] == AERO_BVH_EMPTY) continue;
      const bool leaf = (node.child[i] & AERO_BVH_LEAF) != 0;
      const Ground below = leaf ? patch(node.child[i]) : visit(node.child[i]);
      judge(node.slope[i], below);
      for (int axis = 0; axis < 2; ++axis) all[axis].grow(below[axis]);
    }
    return all;
  }

  void judge(aero_uint slope, const Ground& below) {
    const double steepest = std::max(below[0].steepest(), below[1].steepest());
    if (slope == AERO_SLOPE_UNKNOWN) {
      ++unknown;
      missing += steepest < kSurelyKnown ? 1 : 0;
      return;
    }
    ++known;
    wrong += steepest > kSurelyUnknown ? 1 : 0;
    for (int axis = 0; axis < 2; ++axis) {
      const Range range = told(slope, axis);
      wrong += range.lo > below[axis].lo || range.hi < below[axis].hi ? 1 : 0;
      const double room = 1.02 * kStep;
      loose += range.lo < below[axis].lo - room || range.hi > below[axis].hi + room ? 1 : 0;
    }
  }

  // Returns the slopes of the triangles themselves, computed from their planes.
  Ground patch(aero_uint child) const {
    const bool wide = (child >> AERO_PATCH_SHAPE_SHIFT & AERO_PATCH_SHAPE_MASK) == AERO_PATCH_WIDE;
    const aero_uint i0 = child & AERO_PATCH_CELL_MASK;
    const aero_uint j0 = child >> AERO_PATCH_ROW_SHIFT & AERO_PATCH_CELL_MASK;
    Ground ground;
    for (aero_uint j = j0; j < std::min(j0 + (wide ? 2 : 4), mesh_.rows()); ++j) {
      for (aero_uint i = i0; i < std::min(i0 + (wide ? 4 : 2), mesh_.columns()); ++i)
        add_cell(ground, i, j);
    }
    return ground;
  }

  void add_cell(Ground& ground, aero_uint i, aero_uint j) const {
    const dvec3 corner[4] = {mesh_.position(i, j), mesh_.position(i + 1, j),
                             mesh_.position(i, j + 1), mesh_.position(i + 1, j + 1)};
    // A cell may be split along either diagonal. Its triangles are two of these four.
    const int triangles[4][3] = {{0, 2, 1}, {1, 2, 3}, {0, 2, 3}, {0, 3, 1}};
    for (const auto& t : triangles) {
      const dvec3 n = glm::cross(corner[t[1]] - corner[t[0]], corner[t[2]] - corner[t[0]]);
      ground[0].grow(-n.x / n.y);
      ground[1].grow(-n.z / n.y);
    }
  }

  const Bvh& tree_;
  const mesh::GridMesh& mesh_;
};

// Returns bumps that get steeper to the right, so that the slopes of neighbours differ.
mesh::GridMesh bumps(std::uint32_t columns, std::uint32_t rows, float height) {
  mesh::GridMesh mesh(test::grid_lines(columns), test::grid_lines(rows));
  for (std::uint32_t j = 0; j <= rows; ++j) {
    for (std::uint32_t i = 0; i <= columns; ++i) {
      const float x = mesh.x(i), z = mesh.z(j);
      const float y = std::sin(5.0f * x) * std::cos(4.0f * z) + 0.1f * x * std::sin(31.0f * x * z);
      mesh.set(i, j, height * y, vec3(0.0f, 1.0f, 0.0f));
    }
  }
  return mesh;
}

TEST(BvhSlopes, HoldThoseOfTheTrianglesBelowAndHardlyMore) {
  for (const auto& [columns, rows] : {std::pair(1u, 1u),
                                      {3u, 3u},
                                      {9u, 8u},
                                      {37u, 31u},
                                      {1u, 200u},
                                      {257u, 255u},
                                      {500u, 300u}}) {
    for (const float height : {0.0f, 0.02f, 0.3f, 1.0f}) {
      SCOPED_TRACE(testing::Message() << columns << " x " << rows << ", height " << height);
      const mesh::GridMesh mesh = bumps(columns, rows, height);
      const SlopeInspector seen(bvh::build_grid(mesh), mesh);
      EXPECT_EQ(seen.wrong, 0);
      EXPECT_EQ(seen.loose, 0);
      EXPECT_EQ(seen.missing, 0);
      EXPECT_GT(seen.known, 0);
    }
  }
}

TEST(BvhSlopes, AreUnknownWhereTheGroundIsSteeperThanBytesTell) {
  const mesh::GridMesh mesh = bumps(200, 200, 3.0f);
  const SlopeInspector seen(bvh::build_grid(mesh), mesh);
  EXPECT_EQ(seen.wrong, 0);
  EXPECT_EQ(seen.loose, 0);
  EXPECT_EQ(seen.missing, 0);
  EXPECT_GT(seen.known, 100);
  EXPECT_GT(seen.unknown, 100);
}

bool knows_nothing(const AeroBvhNode& node) {
  return std::all_of(std::begin(node.slope), std::end(node.slope),
                     [](aero_uint slope) { return slope == AERO_SLOPE_UNKNOWN; });
}

bool knows_nothing(const Bvh& tree) {
  return std::all_of(tree.nodes.begin(), tree.nodes.end(),
                     [](const AeroBvhNode& node) { return knows_nothing(node); });
}

TEST(BvhSlopes, AreUnknownInTreesOfMeshesAndInstances) {
  const test::Soup soup = test::terrain(40);
  const Bvh mesh = bvh::build(soup.positions, soup.triangles);
  EXPECT_TRUE(knows_nothing(mesh));
  const std::vector<bvh::Bounds> boxes(50, bvh::Bounds{vec3(0.0f), vec3(1.0f)});
  EXPECT_TRUE(knows_nothing(bvh::build_instances(boxes)));
  EXPECT_TRUE(knows_nothing(bvh::build({}, {})));
}

// Counts the children with a range of slopes, and those of them that contain more than ground.
class GroundAlone {
 public:
  explicit GroundAlone(const Bvh& tree) : tree_(tree) { visit(0); }
  int wrong = 0, known = 0;

 private:
  bool visit(std::uint32_t index) {
    bool all = true;
    const AeroBvhNode& node = tree_.nodes.at(index);
    for (int i = 0; i < AERO_BVH_WIDTH; ++i) {
      const aero_uint child = node.child[i];
      if (child == AERO_BVH_EMPTY) continue;
      const bool leaf = (child & AERO_BVH_LEAF) != 0;
      const bool patch =
          leaf && (child & AERO_BVH_PATCH) != 0 &&
          (child >> AERO_PATCH_SHAPE_SHIFT & AERO_PATCH_SHAPE_MASK) < AERO_PATCH_INSTANCE;
      const bool ground = leaf ? patch : visit(child);
      all &= ground;
      if (node.slope[i] == AERO_SLOPE_UNKNOWN) continue;
      ++known;
      wrong += ground ? 0 : 1;
    }
    return all;
  }

  const Bvh& tree_;
};

TEST(BvhSlopes, OfJoinedTreesAreThoseOfTheGroundAlone) {
  const mesh::GridMesh mesh = bumps(100, 60, 0.3f);
  const test::Soup soup = test::sphere(12);
  const Bvh ground = bvh::build_grid(mesh), ball = bvh::build(soup.positions, soup.triangles);
  const std::vector<bvh::Bounds> boxes(50, ball.bounds);
  const Bvh plants = bvh::build_instances(boxes);
  const bvh::Part parts[] = {{&ground}, {&ball}, {&plants}, {&ball, true}};
  const bvh::JoinedBvh joined = bvh::join(parts);
  const GroundAlone before(ground), after(joined);
  EXPECT_GT(before.known, 0);
  EXPECT_EQ(after.known, before.known);
  EXPECT_EQ(after.wrong, 0);
  EXPECT_TRUE(knows_nothing(joined.nodes.front()));

  const bvh::Part meshes[] = {{&ball}, {&ball}, {&ball, true}};
  EXPECT_TRUE(knows_nothing(bvh::join(meshes)));
}

}  // namespace
}  // namespace aerostat
