#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/envelope.hpp"
#include "model/shapes.hpp"

namespace aerostat::model {
namespace {

constexpr int kMostCells = 8;
constexpr int kMostRows = 14;
/// The bulge of a gore as a share of its width. Chosen by eye.
constexpr double kBulge = 0.05;
/// The distance by which the sides curve inwards, as a share of the mouth's radius. Chosen by eye.
constexpr double kWaist = 0.10;
constexpr double kStep = 1e-4;

struct SkirtShape {
  const EnvelopeShape& envelope;
  double lower_radius, depth;

  /// Returns a point of the skirt. `gores_around` counts from the first tape, and `up` runs from 0
  /// at the hem to 1 at the mouth.
  dvec3 at(double gores_around, double up) const {
    const double top = envelope.mouth_radius();
    const double turn = 2.0 * std::numbers::pi / envelope.gores();
    const double share = gores_around - std::floor(gores_around);
    const double fade = 4.0 * up * (1.0 - up);
    const double plain = lower_radius + (top - lower_radius) * up - kWaist * top * 0.5 * fade;
    const double loose = 1.0 - up;
    const double radius = plain + kBulge * turn * plain * loose * 4.0 * share * (1.0 - share);
    const double angle = envelope.tape_angle(0) + turn * gores_around;
    return {radius * std::cos(angle), depth * (up - 1.0), -radius * std::sin(angle)};
  }

  /// Returns the normal on the side of gore `gore`. At the seam the bulge has a crease, so each
  /// gore has its own normal there.
  dvec3 normal(int gore, double share, double up) const {
    const auto surface = [this](double u, double v) { return at(u, v); };
    const double beside = std::clamp(share, 2.0 * kStep, 1.0 - 2.0 * kStep);
    return surface_normal(surface, gore + beside, up, kStep);
  }
};

}  // namespace

mesh::TriangleMesh build_skirt(const EnvelopeShape& shape, const EnvelopePattern& pattern,
                               double lower_radius, double depth, const Detail& detail) {
  const SkirtShape skirt{shape, lower_radius, depth};
  const double tolerance = detail.envelope_m, top = shape.mouth_radius();
  const int cells = steps_within(tolerance, 6.0 / shape.gores() * kBulge * top, kMostCells);
  const int rows = steps_within(tolerance, kWaist * top, kMostRows);
  mesh::TriangleMesh mesh;
  const vec3 cloth = pattern.skirt();
  for (int gore = 0; gore < shape.gores(); ++gore) {
    add_grid(mesh, {cells, rows}, [&](int i, int j) {
      const double share = static_cast<double>(i) / cells, up = static_cast<double>(j) / rows;
      mesh.uvs.emplace_back(gore + share, 0.5 + 0.5 * up);
      const int owner = i == cells ? (gore + 1) % shape.gores() : gore;
      const double around = owner + (i == cells ? 0.0 : share);
      return Vertex{skirt.at(around, up), skirt.normal(gore, share, up), cloth};
    });
  }
  mesh::TriangleMesh hem;
  add_torus(hem, {0.0, -depth, 0.0}, lower_radius, 0.012,
            sides_within(tolerance, lower_radius, shape.gores(), shape.gores() * 8),
            sides_within(tolerance, 0.012, 3, 8), cloth * 0.55f);
  mesh::append(mesh, hem);
  return mesh;
}

}  // namespace aerostat::model
