#include "model/envelope.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "model/natural_shape.hpp"
#include "model/phase_cut.hpp"
#include "support/mesh_checks.hpp"

namespace aerostat::model {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

scene::Balloon painted(scene::Pattern pattern, int gores = 24) {
  scene::Balloon balloon;
  balloon.pattern = pattern;
  balloon.gores = gores;
  balloon.colors = {{0.7f, 0.05f, 0.02f}, {0.8f, 0.6f, 0.1f}, {0.05f, 0.1f, 0.5f}};
  return balloon;
}

mesh::TriangleMesh envelope_of(const scene::Balloon& balloon, const Detail& detail = {}) {
  const EnvelopeShape shape(balloon.diameter_m, balloon.gores);
  return build_envelope(shape, EnvelopePattern(balloon, shape.panels()), detail);
}

constexpr scene::Pattern kPatterns[] = {scene::Pattern::stripes, scene::Pattern::chevrons,
                                        scene::Pattern::spiral, scene::Pattern::rainbow,
                                        scene::Pattern::checker};

TEST(NaturalShape, HasThePublishedProportions) {
  const NaturalShape& shape = natural_shape();
  EXPECT_NEAR(shape.start_angle() * 360.0 / kTwoPi, 50.15, 0.02);
  EXPECT_NEAR(shape.height(), 0.985, 0.001);
  EXPECT_NEAR(shape.arc_length(), 1.529, 0.001);
  EXPECT_NEAR(shape.volume(), 0.4506, 0.0002);
}

TEST(NaturalShape, FollowsThePublishedTable) {
  const NaturalShape& shape = natural_shape();
  const double table[] = {0, .235, .462, .663, .822, .932, .990, .995, .938, .788, 0};
  for (int i = 0; i <= 10; ++i) {
    const double height = shape.height() * i / 10.0;
    double low = 0.0, high = shape.arc_length();
    for (int step = 0; step < 60; ++step) {
      const double middle = (low + high) / 2.0;
      (shape.at(middle).height < height ? low : high) = middle;
    }
    // At the crown the curve is level, so every arc near the end has that height.
    const double radius = i == 10 ? shape.at(shape.arc_length()).radius : shape.at(low).radius;
    EXPECT_NEAR(radius * 2.0, table[i], 0.0015) << "at " << i << " tenths of the height";
  }
}

TEST(NaturalShape, ComesToTheAxisLevel) {
  const NaturalShape& shape = natural_shape();
  // The last step is excluded, because the curve is closed by force there.
  const double step = shape.arc_length() / 2048.0;
  const MeridianPoint before = shape.at(shape.arc_length() - step);
  EXPECT_NEAR(before.radius / step, 1.0, 1e-6);
  EXPECT_NEAR(before.angle + kTwoPi / 4.0, -before.curvature * step / 2.0, 1e-9);
}

TEST(NaturalShape, SolvesItsEquations) {
  const NaturalShape& shape = natural_shape();
  const double h = 1e-4,
               k = -shape.at(0.8).curvature / (shape.at(0.8).height * shape.at(0.8).radius);
  for (double s = 0.01; s < 1.5; s += 0.0137) {
    const MeridianPoint a = shape.at(s - h), p = shape.at(s), b = shape.at(s + h);
    EXPECT_NEAR((b.radius - a.radius) / (2 * h), std::sin(p.angle), 1e-5);
    EXPECT_NEAR((b.height - a.height) / (2 * h), std::cos(p.angle), 1e-5);
    EXPECT_NEAR((b.angle - a.angle) / (2 * h), -k * p.height * p.radius, 1e-3);
  }
}

TEST(NaturalShape, FindsTheArcOfARadius) {
  const NaturalShape& shape = natural_shape();
  for (const double radius : {0.02, 0.085, 0.3, 0.49}) {
    const double below = shape.arc_below_equator(radius), above = shape.arc_above_equator(radius);
    EXPECT_LT(below, above);
    EXPECT_NEAR(shape.at(below).radius, radius, 1e-6);
    EXPECT_NEAR(shape.at(above).radius, radius, 1e-5);
  }
}

TEST(EnvelopeShape, RepeatsFromGoreToGore) {
  const EnvelopeShape shape(18.8, 24);
  const double turn = kTwoPi / 24.0;
  for (double arc = shape.mouth_arc(); arc < shape.crown_arc(); arc += 1.7) {
    const EnvelopeRow row{arc, 0.3};
    for (const double share : {0.02, 0.3, 0.5}) {
      const FabricPoint a = shape.fabric(0, share, row), b = shape.fabric(7, share, row);
      const double c = std::cos(7.0 * turn), s = std::sin(7.0 * turn);
      const auto turned = [&](const dvec3& v) {
        return dvec3(c * v.x + s * v.z, v.y, -s * v.x + c * v.z);
      };
      EXPECT_NEAR(glm::distance(turned(a.position), b.position), 0.0, 1e-9);
      EXPECT_NEAR(glm::distance(turned(a.normal), b.normal), 0.0, 1e-9);
      // A gore is symmetric.
      const FabricPoint mirror = shape.fabric(0, 1.0 - share, row);
      EXPECT_NEAR(mirror.position.y, a.position.y, 1e-9);
    }
  }
}

TEST(EnvelopeShape, BulgesOutwardsBetweenTheTapesOnly) {
  const EnvelopeShape shape(20.0, 24);
  const auto radius = [&](double arc, double share) {
    const dvec3 p = shape.fabric(3, share, {arc, 0.0}).position;
    return std::hypot(p.x, p.z);
  };
  const double equator = 20.0 * natural_shape().arc_below_equator(0.4999);
  EXPECT_NEAR(radius(equator, 0.0), 10.0, 0.003);
  EXPECT_GT(radius(equator, 0.5), 10.1);
  EXPECT_LT(radius(equator, 0.5), 10.4);
  EXPECT_NEAR(radius(shape.mouth_arc(), 0.5), shape.mouth_radius(), 1e-6);
  EXPECT_NEAR(shape.mouth_radius(), 0.17 * 10.0, 1e-9);
  EXPECT_NEAR(radius(shape.disc_arc(), 0.5), radius(shape.disc_arc(), 0.0), 1e-9);
}

TEST(EnvelopeShape, NormalsMatchDifferences) {
  const EnvelopeShape shape(18.8, 16);
  const double h = 1e-5;
  for (double arc = shape.mouth_arc() + 0.1; arc < shape.crown_arc() - 0.1; arc += 0.93) {
    for (const double share : {0.05, 0.37, 0.5, 0.9}) {
      const auto at = [&](double ds, double du) {
        return shape.fabric(2, share + du, {arc + ds, 0.5}).position;
      };
      const dvec3 expected = glm::normalize(glm::cross(at(0, h) - at(0, -h), at(h, 0) - at(-h, 0)));
      EXPECT_GT(glm::dot(expected, shape.fabric(2, share, {arc, 0.5}).normal), 0.99999);
    }
  }
}

TEST(EnvelopeShape, RefusesWhatCannotBeBuilt) {
  EXPECT_THROW(EnvelopeShape(0.0, 24), Error);
  EXPECT_THROW(EnvelopeShape(std::nan(""), 24), Error);
  EXPECT_THROW(EnvelopeShape(18.8, 2), Error);
  scene::Balloon bare;
  EXPECT_THROW(EnvelopePattern(bare, 20), Error);
}

TEST(Envelope, IsOneSheetOpenAtTheMouthAlone) {
  for (const scene::Pattern pattern : kPatterns) {
    for (const int gores : {24, 13}) {
      for (const double tolerance : {0.0, 0.01, 0.1, 3.0}) {
        const mesh::TriangleMesh mesh =
            envelope_of(painted(pattern, gores), {tolerance, tolerance});
        const test::Edges edges = test::count_edges(mesh);
        EXPECT_EQ(edges.crowded, 0u);
        // The pattern may cut the edges of the mouth, but no other edge is open.
        const std::size_t cells = tolerance == 0.0 ? 8 : 2;
        EXPECT_GE(edges.open, static_cast<std::size_t>(gores) * cells);
        EXPECT_LE(edges.open, static_cast<std::size_t>(gores) * 12);
        for (const vec3& v : edges.open_vertices) EXPECT_NEAR(v.y, 0.0f, 0.02f);
      }
    }
  }
}

/// Returns an upper bound of the distance of a point from the plane of the nearest triangle around
/// it.
double off_mesh(const mesh::TriangleMesh& mesh, const dvec3& point) {
  double nearest = 1e9;
  for (const uvec3& t : mesh.triangles) {
    const dvec3 a(mesh.positions[t.x]), u = dvec3(mesh.positions[t.y]) - a;
    const dvec3 v = dvec3(mesh.positions[t.z]) - a, n = glm::normalize(glm::cross(u, v));
    const double away = glm::dot(point - a, n);
    const dvec3 on = point - away * n - a;
    const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v);
    const double det = uu * vv - uv * uv;
    const double s = (glm::dot(on, u) * vv - glm::dot(on, v) * uv) / det;
    const double w = (glm::dot(on, v) * uu - glm::dot(on, u) * uv) / det;
    if (s > -0.05 && w > -0.05 && s + w < 1.05) nearest = std::min(nearest, std::abs(away));
  }
  return nearest;
}

TEST(Envelope, FacetsStayWithinTheToleranceOfTheSurface) {
  const scene::Balloon balloon = painted(scene::Pattern::stripes);
  const EnvelopeShape shape(balloon.diameter_m, balloon.gores);
  const double panel = (shape.disc_arc() - shape.mouth_arc()) / shape.panels();
  for (const double tolerance : {0.0078125, 0.0625, 0.25}) {
    const mesh::TriangleMesh mesh = envelope_of(balloon, {tolerance, tolerance});
    double worst = 0.0;
    for (int i = 0; i < 40; ++i) {
      const double up = 0.3 + 0.49 * i, share = 0.05 + 0.9 * (i * 7 % 40) / 40.0;
      const EnvelopeRow row{shape.mouth_arc() + panel * up, up - std::floor(up)};
      worst = std::max(worst, off_mesh(mesh, shape.fabric(i % 24, share, row).position));
    }
    // The errors of both directions of a cell add up, and the pieces of a cell are two triangles.
    EXPECT_LT(worst, 2.0 * tolerance);
    EXPECT_GT(worst, 0.1 * tolerance) << "finer than need be";
  }
}

TEST(Envelope, UvsCountGoresAndPanels) {
  const scene::Balloon balloon = painted(scene::Pattern::spiral);
  const EnvelopeShape shape(balloon.diameter_m, balloon.gores);
  const mesh::TriangleMesh mesh = envelope_of(balloon);
  ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
  for (const uvec3& t : mesh.triangles) {
    const vec2 a = mesh.uvs[t.x], b = mesh.uvs[t.y], c = mesh.uvs[t.z];
    // No triangle crosses a tape or a seam.
    const vec2 low = glm::min(glm::min(a, b), c), high = glm::max(glm::max(a, b), c);
    ASSERT_LE(high.x - std::floor(low.x + 1e-4f), 1.0f + 1e-4f);
    ASSERT_LE(high.y - std::floor(low.y + 1e-4f), 1.0f + 1e-4f);
  }
  const double turn = kTwoPi / balloon.gores;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 31) {
    const vec3 p = mesh.positions[i];
    if (std::hypot(p.x, p.z) < 0.5f) continue;
    const double angle = shape.tape_angle(0) + turn * static_cast<double>(mesh.uvs[i].x);
    EXPECT_NEAR(std::remainder(std::atan2(-p.z, p.x) - angle, kTwoPi), 0.0, 1e-3);
  }
}

TEST(Envelope, ManyGoresApproachTheNaturalVolume) {
  const scene::Balloon balloon = painted(scene::Pattern::stripes, 160);
  const double cubed = std::pow(balloon.diameter_m, 3.0);
  // The apex is the middle of the mouth, so the opening itself adds nothing to the volume.
  EXPECT_NEAR(test::volume(envelope_of(balloon)) / cubed, 0.4506, 0.004);
}

TEST(Envelope, TakesItsSizeFromTheDiameter) {
  scene::Balloon balloon = painted(scene::Pattern::stripes);
  balloon.diameter_m = 25.0;
  float widest = 0.0f, top = 0.0f;
  for (const vec3& p : envelope_of(balloon).positions) {
    widest = std::max(widest, std::hypot(p.x, p.z));
    top = std::max(top, p.y);
  }
  EXPECT_NEAR(widest, 12.5f, 0.3f);
  EXPECT_GT(widest, 12.5f);
  EXPECT_NEAR(top, EnvelopeShape(25.0, 24).height(), 0.03);
}

TEST(Envelope, EveryTriangleHasOneColor) {
  for (const scene::Pattern pattern : kPatterns) {
    const mesh::TriangleMesh mesh = envelope_of(painted(pattern));
    for (const uvec3& t : mesh.triangles) {
      ASSERT_EQ(mesh.colors[t.x], mesh.colors[t.y]);
      ASSERT_EQ(mesh.colors[t.x], mesh.colors[t.z]);
    }
  }
}

TEST(Envelope, ShowsTheWholePalette) {
  for (const scene::Pattern pattern : kPatterns) {
    const scene::Balloon balloon = painted(pattern);
    const mesh::TriangleMesh mesh = envelope_of(balloon);
    std::vector<double> areas(balloon.colors.size(), 0.0);
    double whole = 0.0;
    for (const uvec3& t : mesh.triangles) {
      whole += test::area(mesh, t);
      const vec3 shown = glm::normalize(mesh.colors[t.x]);
      for (std::size_t i = 0; i < areas.size(); ++i) {
        if (glm::dot(shown, glm::normalize(balloon.colors[i])) > 0.9999f)
          areas[i] += test::area(mesh, t);
      }
    }
    for (const double area : areas) EXPECT_GT(area, 0.15 * whole);
  }
}

TEST(PhaseCut, PiecesFillTheTriangleAndKeepToTheirBands) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> phase(-3.0, 3.0);
  for (int round = 0; round < 500; ++round) {
    std::array<CutVertex, 3> triangle{
        {{{0, 0, 0}, {0, 0, 1}, {0, 0}, quantized_phase(phase(random))},
         {{1, 0, 0}, {0, 0, 1}, {0, 0}, quantized_phase(phase(random))},
         {{0, 1, 0}, {0, 0, 1}, {0, 0}, quantized_phase(phase(random))}}};
    double filled = 0.0;
    for (const CutPiece& piece : cut_by_phase(triangle)) {
      ASSERT_GE(piece.corners.size(), 3u);
      for (const CutVertex& v : piece.corners) {
        EXPECT_GE(v.phase, piece.band);
        EXPECT_LE(v.phase, piece.band + 1.0);
      }
      for (std::size_t i = 2; i < piece.corners.size(); ++i) {
        const vec3 a = piece.corners[0].position;
        filled +=
            0.5 * glm::cross(piece.corners[i - 1].position - a, piece.corners[i].position - a).z;
      }
    }
    EXPECT_NEAR(filled, 0.5, 1e-5);
  }
}

TEST(Skirt, HangsFromTheMouth) {
  const scene::Balloon balloon = painted(scene::Pattern::stripes);
  const EnvelopeShape shape(balloon.diameter_m, balloon.gores);
  const mesh::TriangleMesh mesh =
      build_skirt(shape, EnvelopePattern(balloon, shape.panels()), 1.0, 1.1);
  float top = -10.0f, bottom = 10.0f;
  for (const vec3& p : mesh.positions) {
    top = std::max(top, p.y);
    bottom = std::min(bottom, p.y);
    if (p.y < -1e-6f) continue;
    EXPECT_NEAR(std::hypot(p.x, p.z), shape.mouth_radius(), 1e-3);
  }
  EXPECT_NEAR(top, 0.0f, 1e-6f);
  EXPECT_NEAR(bottom, -1.112f, 1e-3f);
  EXPECT_GT(test::worst_normal(mesh), 0.8);
}

}  // namespace
}  // namespace aerostat::model
