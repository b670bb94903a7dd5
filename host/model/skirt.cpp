#include <cmath>
#include <numbers>

#include "model/envelope.hpp"
#include "model/shapes.hpp"

namespace aerostat::model {
namespace {

constexpr int kCells = 6;
constexpr int kRows = 14;
constexpr double kTapeShare = 0.035;  // half the width of a seam, as a share of a gore
constexpr double kBulge = 0.05;       // of a gore's width
constexpr double kWaist = 0.10;       // how far the sides curve inwards, of the mouth's radius
constexpr double kStep = 1e-4;

struct SkirtShape {
  const EnvelopeShape& envelope;
  double lower_radius, depth;

  /// `gores_around` from the first tape, `up` from 0 at the hem to 1 at the mouth.
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

  Vertex vertex(double gores_around, double up, const vec3& color) const {
    const auto surface = [this](double u, double v) { return at(u, v); };
    return {at(gores_around, up), surface_normal(surface, gores_around, up, kStep), color};
  }
};

}  // namespace

mesh::TriangleMesh build_skirt(const EnvelopeShape& shape, const EnvelopePattern& pattern,
                               double lower_radius, double depth) {
  const SkirtShape skirt{shape, lower_radius, depth};
  mesh::TriangleMesh mesh;
  const vec3 cloth = pattern.skirt(), seam = cloth * 0.55f;
  for (int gore = 0; gore < shape.gores(); ++gore) {
    const auto strip = [&](double from, double to, int cells, const vec3& color) {
      add_grid(mesh, {cells, kRows}, [&](int i, int j) {
        const double share = from + (to - from) * i / cells;
        // Kept off the seam itself, where the bulge has a crease.
        return skirt.vertex(gore + share, static_cast<double>(j) / kRows, color);
      });
    };
    strip(2.0 * kStep, kTapeShare, 1, seam);
    strip(kTapeShare, 1.0 - kTapeShare, kCells, cloth);
    strip(1.0 - kTapeShare, 1.0 - 2.0 * kStep, 1, seam);
  }
  const dvec3 hem(0.0, -depth, 0.0);
  add_torus(mesh, hem, lower_radius, 0.012, shape.gores() * 8, 8, seam);
  return mesh;
}

}  // namespace aerostat::model
