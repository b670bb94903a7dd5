#include "model/balloon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "model/dimensions.hpp"
#include "model/rigging.hpp"
#include "model/rim.hpp"
#include "model/shapes.hpp"
#include "support/mesh_checks.hpp"

namespace aerostat::model {
namespace {

using scene::ObjectId;

constexpr double kPi = std::numbers::pi;

scene::Balloon sample(scene::Pattern pattern = scene::Pattern::stripes) {
  scene::Balloon balloon;
  balloon.pattern = pattern;
  balloon.colors = {{0.7f, 0.05f, 0.02f}, {0.8f, 0.6f, 0.1f}};
  return balloon;
}

const mesh::TriangleMesh& part(const std::vector<Part>& parts, ObjectId id) {
  for (const Part& p : parts) {
    if (p.id == id) return p.mesh;
  }
  throw std::runtime_error("part not found");
}

/// Returns whether a ray from `origin` along `direction` hits a triangle.
bool hits(const mesh::TriangleMesh& mesh, const dvec3& origin, const dvec3& direction) {
  for (const uvec3& t : mesh.triangles) {
    const dvec3 a(mesh.positions[t.x]), u = dvec3(mesh.positions[t.y]) - a;
    const dvec3 v = dvec3(mesh.positions[t.z]) - a, p = glm::cross(direction, v);
    const double det = glm::dot(u, p);
    if (std::abs(det) < 1e-15) continue;
    const dvec3 s = origin - a, q = glm::cross(s, u);
    const double beta = glm::dot(s, p) / det, gamma = glm::dot(direction, q) / det;
    if (beta >= 0 && gamma >= 0 && beta + gamma <= 1 && glm::dot(v, q) / det > 0) return true;
  }
  return false;
}

TEST(Shapes, HaveTheVolumesOfTheBooks) {
  mesh::TriangleMesh box, sphere, torus, rod;
  add_box(box, {1, 2, 3}, {0.5, 1.0, 1.5}, vec3(1));
  EXPECT_NEAR(test::volume(box), 6.0, 1e-6);
  add_sphere(sphere, {0, 5, 0}, 2.0, 96, vec3(1));
  EXPECT_NEAR(test::volume(sphere) / (4.0 / 3.0 * kPi * 8.0), 1.0, 0.004);
  add_torus(torus, {1, 0, 0}, 3.0, 0.5, 128, 48, vec3(1));
  EXPECT_NEAR(test::volume(torus) / (2.0 * kPi * kPi * 3.0 * 0.25), 1.0, 0.005);
  add_rod(rod, {0, 0, 0}, {1, 2, 2}, 0.25, 64, vec3(1));
  EXPECT_NEAR(test::volume(rod) / (kPi * 0.0625 * 3.0), 1.0, 0.003);
  for (const auto* mesh : {&box, &sphere, &torus, &rod}) {
    EXPECT_EQ(test::count_edges(*mesh).open, 0u);
    EXPECT_GT(test::worst_normal(*mesh), 0.99);
  }
}

TEST(Shapes, LatheKeepsSharpEdges) {
  mesh::TriangleMesh can;
  const dvec2 profile[] = {{0, 0}, {1, 0}, {1, 2}, {0, 2}};
  add_lathe(can, {0, 0, 0}, profile, 64, [](std::size_t) { return vec3(1); });
  EXPECT_NEAR(test::volume(can) / (2.0 * kPi), 1.0, 0.003);
  EXPECT_EQ(test::count_edges(can).open, 0u);
  for (const vec3& n : can.normals) EXPECT_TRUE(std::abs(n.y) < 1e-6f || std::abs(n.y) > 0.999f);
}

TEST(Outline, ClosesSmoothly) {
  const Outline outline = wall_outline();
  const double length = outline.length(), h = 1e-5;
  for (double d = 0.0; d < length; d += 0.0371) {
    const Outline::Point a = outline.at(d), b = outline.at(d + h);
    EXPECT_NEAR(glm::distance(a.position, b.position), h, 1e-8);
    EXPECT_GT(glm::dot(glm::normalize(b.position - a.position), a.tangent), 0.9999);
    EXPECT_NEAR(glm::length(a.normal), 1.0, 1e-12);
    EXPECT_GT(glm::dot(a.normal, a.position), 0.0);
  }
  EXPECT_NEAR(glm::distance(outline.at(0.0).position, outline.at(length).position), 0.0, 1e-9);
  EXPECT_NEAR(glm::distance(outline.at(-0.1).position, outline.at(length - 0.1).position), 0.0,
              1e-9);
}

TEST(Balloon, HasOneSoundPartOfEachKind) {
  for (int pattern = 0; pattern < 5; ++pattern) {
    const std::vector<Part> parts = balloon(sample(static_cast<scene::Pattern>(pattern)));
    ASSERT_EQ(parts.size(), 8u);
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_EQ(parts[i].id,
                static_cast<ObjectId>(static_cast<std::uint32_t>(ObjectId::envelope) + i));
      const mesh::TriangleMesh& mesh = parts[i].mesh;
      EXPECT_NO_THROW(mesh::check(mesh, "part"));
      ASSERT_FALSE(mesh.empty());
      ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
      triangles += mesh.triangles.size();
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        ASSERT_TRUE(is_finite(mesh.positions[v]));
        ASSERT_NEAR(glm::length(mesh.normals[v]), 1.0f, 1e-5f);
        for (int c = 0; c < 3; ++c)
          ASSERT_TRUE(mesh.colors[v][c] >= 0.0f && mesh.colors[v][c] <= 1.0f);
      }
      EXPECT_GT(test::worst_normal(mesh), 0.2) << "part " << i;
    }
    EXPECT_LT(triangles, 500000u);
  }
}

TEST(Balloon, HasNoDegenerateTriangleEvenFarOut) {
  scene::Balloon far = sample(scene::Pattern::chevrons);
  far.position = {3500.0, 1900.0, -2800.0};
  far.heading_deg = 33.0;
  for (const Part& p : balloon(far)) {
    for (const uvec3& t : p.mesh.triangles) ASSERT_GT(test::area(p.mesh, t), 0.0);
  }
}

TEST(Balloon, SolidPartsAreClosedAtEveryLevelOfDetail) {
  for (const double tolerance : {0.0, 0.0005, 0.002, 0.0078125, 0.0625, 0.5, 16.0}) {
    const std::vector<Part> parts = balloon(sample(), {tolerance, tolerance});
    for (const ObjectId id : {ObjectId::basket, ObjectId::rim, ObjectId::frame, ObjectId::cables,
                              ObjectId::floor, ObjectId::flame}) {
      const test::Edges edges = test::count_edges(part(parts, id));
      EXPECT_EQ(edges.open, 0u) << "part " << static_cast<int>(id) << " at " << tolerance;
      EXPECT_EQ(edges.crowded, 0u) << "part " << static_cast<int>(id) << " at " << tolerance;
      EXPECT_GT(test::volume(part(parts, id)), 0.0);
      EXPECT_GT(test::worst_normal(part(parts, id)), 0.2) << static_cast<int>(id);
    }
  }
}

TEST(Balloon, HasTheTrianglesThatItsSizeInThePictureAsksFor) {
  const auto triangles = [](const dvec3& eye, double pixel_angle) {
    std::size_t count = 0;
    for (const Part& p : balloon(sample(), detail_for(sample(), eye, {pixel_angle, 0.0})))
      count += p.mesh.triangles.size();
    return count;
  };
  // The angle of a pixel for 720 lines over 45 degrees, in radians.
  const double pixel = 1.15e-3;
  EXPECT_GT(triangles({0.0, 1.6, 0.0}, pixel), 200000u);
  EXPECT_LT(triangles({0.0, 5.0, 86.0}, pixel), 40000u);
  EXPECT_LT(triangles({0.0, 5.0, 2000.0}, pixel), 10000u);
}

TEST(Detail, GoesWithThePixelInStepsOfTwo) {
  const scene::Balloon b = sample();
  const Detail far = detail_for(b, {0.0, 5.0, 86.0}, {1e-3, 0.0});
  // The eye is 85 m from the basket and 76.6 m from the envelope, where a pixel is 85 mm and 77 mm
  // wide. An eighth of these is rounded down to a power of two.
  EXPECT_DOUBLE_EQ(far.basket_m, 0x1p-7);
  EXPECT_DOUBLE_EQ(far.envelope_m, 0x1p-7);
  EXPECT_EQ(detail_for(b, {0.0, 5.0, 86.0}, {2e-3, 0.0}).envelope_m, 2.0 * far.envelope_m);
  EXPECT_EQ(detail_for(b, {0.3, 5.0, 86.0}, {1e-3, 0.0}), far) << "a step changes nothing";
  EXPECT_EQ(detail_for(b, basket_eye(b), {1e-3, 0.0}).basket_m, 0.0);
  EXPECT_EQ(detail_for(b, {0.0, 5.0, 1e9}, {1e-3, 0.0}).basket_m, 16.0);
  for (const double tolerance : {0.001, 0.02, 0.3}) {
    const int sides = sides_within(tolerance, 1.0, 3, 1000);
    EXPECT_LE(1.0 - std::cos(kPi / sides), tolerance);
    EXPECT_GT(1.0 - std::cos(kPi / (sides - 1)), tolerance);
  }
  EXPECT_EQ(steps_within(0.01, 0.04, 100), 2);
  EXPECT_EQ(steps_within(0.01, 0.0401, 100), 3);
  EXPECT_EQ(steps_within(0.0, 0.04, 100), 100);
}

TEST(Balloon, ColorsAreClampedAndOneIsEnough) {
  scene::Balloon plain = sample(scene::Pattern::chevrons);
  plain.colors = {{3.0f, -1.0f, 0.5f}};
  for (const Part& p : balloon(plain)) {
    for (const vec3& c : p.mesh.colors) {
      ASSERT_TRUE(c == glm::clamp(c, 0.0f, 1.0f));
    }
  }
  plain.colors.clear();
  EXPECT_THROW(balloon(plain), Error);
}

TEST(Balloon, PositionAndHeadingMoveEverything) {
  scene::Balloon moved = sample();
  moved.position = {100.0, 50.0, -20.0};
  moved.heading_deg = 90.0;
  const std::vector<Part> home = balloon(sample()), away = balloon(moved);
  for (std::size_t i = 0; i < home.size(); ++i) {
    const mesh::TriangleMesh &a = home[i].mesh, &b = away[i].mesh;
    ASSERT_EQ(a.positions.size(), b.positions.size());
    for (std::size_t v = 0; v < a.positions.size(); v += 97) {
      const vec3 p = a.positions[v];
      EXPECT_LT(glm::distance(b.positions[v], vec3(100.0f - p.z, 50.0f + p.y, -20.0f + p.x)),
                2e-5f);
    }
  }
  EXPECT_LT(glm::distance(basket_forward(moved), dvec3(1.0, 0.0, 0.0)), 1e-12);
  EXPECT_LT(glm::distance(basket_forward(sample()), dvec3(0.0, 0.0, -1.0)), 1e-12);
  EXPECT_LT(glm::distance(basket_eye(moved), dvec3(99.75, 51.62, -20.0)), 1e-9);
}

TEST(Balloon, BasketSurroundsTheEye) {
  const scene::Balloon balloon_scene = sample();
  const std::vector<Part> parts = balloon(balloon_scene);
  const dvec3 eye = basket_eye(balloon_scene), chest = eye - dvec3(0.0, 0.8, 0.0);
  for (int i = 0; i < 16; ++i) {
    const double angle = 2.0 * kPi * (i + 0.3) / 16.0;
    const dvec3 out(std::cos(angle), 0.0, std::sin(angle));
    EXPECT_TRUE(hits(part(parts, ObjectId::basket), chest, out));
    EXPECT_FALSE(hits(part(parts, ObjectId::basket), eye, out));
    EXPECT_FALSE(hits(build_rim(wall_outline(), kRimHeight), eye, out));
  }
  EXPECT_TRUE(hits(part(parts, ObjectId::floor), eye, {0.011, -1.0, 0.007}));
  EXPECT_TRUE(hits(part(parts, ObjectId::envelope), eye, {0.011, 1.0, 0.007}));
  // The upper side of the floor is at the balloon's position.
  EXPECT_FALSE(hits(part(parts, ObjectId::floor), {0.2, 0.001, 0.2}, {0.0, 1.0, 0.0}));
  EXPECT_TRUE(hits(part(parts, ObjectId::floor), {0.2, 0.001, 0.2}, {0.0, -1.0, 0.0}));
}

TEST(Balloon, PartsHoldTogether) {
  const EnvelopeShape shape(18.8, 24);
  const double mouth = mouth_height(18.8);
  EXPECT_EQ(flying_wires(shape).size(), 24u);
  for (const Wire& wire : flying_wires(shape)) {
    EXPECT_NEAR(wire.from.y, kFrameHeight, 1e-9);
    EXPECT_NEAR(std::abs(wire.from.x), kFrameHalf.x, 1e-9);
    EXPECT_NEAR(wire.to.y, mouth, 1e-9);
    EXPECT_NEAR(std::hypot(wire.to.x, wire.to.z), shape.mouth_radius(), 1e-9);
    // Each wire stays on the side of its own corner.
    EXPECT_GT(wire.from.x * wire.to.x, 0.0);
    EXPECT_GT(wire.from.z * wire.to.z, 0.0);
  }
  EXPECT_EQ(basket_wires().size(), 8u);
  for (const Wire& wire : basket_wires()) {
    EXPECT_NEAR(wire.to.y, kRimHeight, 1e-9);
    EXPECT_LT(glm::distance(wire.to, wire.from), 1.3);
  }
  EXPECT_GT(rim_half_size().x, kWallHalfThickness);
  EXPECT_LT(kRimHeight - rim_half_size().y, kWallTop);
  float lowest = 1e9f;
  const std::vector<Part> parts = balloon(sample());
  for (const vec3& p : part(parts, ObjectId::envelope).positions) lowest = std::min(lowest, p.y);
  EXPECT_NEAR(lowest, mouth, 0.02);
}

TEST(Balloon, IsTheSameEveryTime) {
  const std::vector<Part> a = balloon(sample()), b = balloon(sample());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].mesh.positions, b[i].mesh.positions);
    EXPECT_EQ(a[i].mesh.triangles, b[i].mesh.triangles);
  }
}

TEST(Balloon, OtherSizesWork) {
  for (const double diameter : {6.0, 40.0}) {
    for (const int gores : {8, 33}) {
      scene::Balloon other = sample(scene::Pattern::spiral);
      other.diameter_m = diameter;
      other.gores = gores;
      const std::vector<Part> parts = balloon(other);
      for (const Part& p : parts) {
        for (const uvec3& t : p.mesh.triangles) ASSERT_GT(test::area(p.mesh, t), 0.0);
      }
      EXPECT_NEAR(balloon_height(other), mouth_height(diameter) + 0.9135 * diameter,
                  0.001 * diameter);
    }
  }
}

}  // namespace
}  // namespace aerostat::model
