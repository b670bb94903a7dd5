#include "model/basket.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/dimensions.hpp"
#include "model/fittings.hpp"
#include "model/shapes.hpp"
#include "model/weave.hpp"

namespace aerostat::model {
namespace {

using mesh::TriangleMesh;

/// The albedos of the basket's materials. Chosen by eye.
const vec3 kPlywood{0.46f, 0.32f, 0.18f};
const vec3 kRunnerWood{0.17f, 0.095f, 0.045f};
const vec3 kRope{0.36f, 0.27f, 0.15f};

/// Adds a rounded strip of leather around the foot of the wall.
void add_scuff(TriangleMesh& mesh, const Outline& wall, double tolerance_m) {
  const int columns = tolerance_m >= 0.002 ? 48 : 160, sides = tolerance_m >= 0.002 ? 8 : 16;
  constexpr double kBottom = -0.06, kTop = 0.075;
  const double middle_height = (kBottom + kTop) / 2.0, half_height = (kTop - kBottom) / 2.0;
  const double outside = kWallHalfThickness + weave_relief() + 0.004;
  const auto surface = [&](double u, double v) {
    const Outline::Point point = wall.at(u * wall.length());
    const double across = 2.0 * std::numbers::pi * v;
    // The cross-section is a flattened ring: the power 0.4 makes the ellipse nearly a rectangle.
    const auto squared = [](double x) { return std::copysign(std::pow(std::abs(x), 0.4), x); };
    const double out = 0.5 * outside * (1.0 + squared(std::cos(across)));
    return point.position + out * point.normal +
           dvec3(0.0, middle_height + half_height * squared(std::sin(across)), 0.0);
  };
  add_grid(mesh, {columns, sides, true, true}, [&](int i, int j) {
    const double u = static_cast<double>(i) / columns;
    const double v = (j + 0.5) / sides;
    return Vertex{surface(u, v), surface_normal(surface, u, v, 1e-4), kLeather * 0.7f};
  });
}

/// Adds a loop of rope whose ends are fixed in the wall.
void add_handle(TriangleMesh& mesh, const Outline::Point& place, double height,
                double tolerance_m) {
  const int points = tolerance_m >= 0.002 ? 7 : 17;
  constexpr double kHalfSpan = 0.09, kSag = 0.08, kReach = 0.07;
  std::vector<dvec3> path;
  for (int i = 0; i < points; ++i) {
    const double angle = std::numbers::pi * i / (points - 1);
    path.push_back(place.position - kHalfSpan * std::cos(angle) * place.tangent +
                   std::sin(angle) * (kReach * place.normal - dvec3(0.0, kSag, 0.0)) +
                   dvec3(0.0, height, 0.0));
  }
  add_tube(mesh, path, 0.011, sides_within(tolerance_m, 0.011, 4, 10), kRope);
}

/// Adds a plank from x0 to x1 whose ends follow the rounded corners of the outline.
void add_plank(TriangleMesh& mesh, const Outline& edge, double x0, double x1, const vec3& color) {
  constexpr int kColumns = 4;
  const auto half_depth = [&edge](double x) {
    const double past = std::max(0.0, std::abs(x) - (edge.half.x - edge.corner_radius));
    const double radius = edge.corner_radius;
    return edge.half.y - radius + std::sqrt(std::max(0.0, radius * radius - past * past));
  };
  const auto corner = [&](int i, double side, double y) {
    const double x = x0 + (x1 - x0) * i / kColumns;
    return dvec3(x, y, side * half_depth(x));
  };
  const auto face = [&](double y) {
    const double up = y < 0.0 ? -1.0 : 1.0;
    add_grid(mesh, {kColumns, 1}, [&](int i, int j) {
      return Vertex{corner(i, j == 0 ? up : -up, y), dvec3(0.0, up, 0.0), color};
    });
  };
  const auto end = [&](double side) {
    add_grid(mesh, {kColumns, 1}, [&](int i, int j) {
      const dvec3 normal(0.0, 0.0, side);
      return Vertex{corner(i, side, (j == 0) == (side > 0.0) ? -kFloorThickness : 0.0), normal,
                    color};
    });
  };
  const auto flank = [&](int i, double side) {
    add_grid(mesh, {1, 1}, [&](int k, int j) {
      return Vertex{
          corner(i, (k == 0) == (side > 0.0) ? 1.0 : -1.0, j == 0 ? -kFloorThickness : 0.0),
          dvec3(side, 0.0, 0.0), color};
    });
  };
  face(0.0);
  face(-kFloorThickness);
  end(1.0);
  end(-1.0);
  flank(0, -1.0);
  flank(kColumns, 1.0);
}

}  // namespace

TriangleMesh build_basket(const Detail& detail) {
  TriangleMesh mesh;
  const double tolerance = detail.basket_m;
  const Outline wall = wall_outline();
  add_woven_wall(mesh, wall, kWallBottom, kWallTop, kWallHalfThickness, tolerance);
  const double outside = kWallHalfThickness + weave_relief() * 0.6;
  add_rope_band(mesh, wall, outside, 0.54, 0.014, tolerance);
  add_rope_band(mesh, wall, outside, 0.985, 0.012, tolerance);
  add_rope_band(mesh, wall, -outside, 0.985, 0.012, tolerance);
  add_scuff(mesh, wall, tolerance);
  const double quarter = wall.length() / 4.0;
  for (int side = 0; side < 4; ++side) {
    for (const double shift : {-0.28, 0.28})
      add_handle(mesh, wall.at(side * quarter + shift), 0.80, tolerance);
  }
  add_sandbags(mesh, detail);
  return mesh;
}

TriangleMesh build_floor() {
  constexpr int kPlanks = 8;
  constexpr double kGap = 0.0015;
  TriangleMesh mesh;
  Outline edge = wall_outline();
  const double half_x = edge.half.x;
  for (int plank = 0; plank < kPlanks; ++plank) {
    const double x0 = half_x * (2.0 * plank / kPlanks - 1.0);
    const double x1 = half_x * (2.0 * (plank + 1) / kPlanks - 1.0);
    const auto tint =
        static_cast<float>(0.85 + 0.3 * hash_unit(static_cast<std::uint32_t>(plank), 5u));
    add_plank(mesh, edge, x0 + kGap, x1 - kGap, kPlywood * tint);
  }
  // The first box is a board under the gaps between the planks.
  add_box(mesh, {0.0, -0.5 * kFloorThickness - 0.004, 0.0},
          {0.50, 0.5 * kFloorThickness - 0.003, 0.64}, kPlywood * 0.25f);
  for (const double x : {-0.38, 0.0, 0.38}) {
    add_box(mesh, {x, -0.075, 0.0}, {0.035, 0.047, 0.70}, kRunnerWood);
  }
  return mesh;
}

}  // namespace aerostat::model
