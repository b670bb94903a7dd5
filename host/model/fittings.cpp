#include "model/fittings.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "model/dimensions.hpp"
#include "model/shapes.hpp"
#include "model/weave.hpp"

namespace aerostat::model {
namespace {

using mesh::TriangleMesh;

constexpr double kPi = std::numbers::pi;
/// The range of a turning vent in panels up from the mouth. Chosen by eye.
constexpr double kVentFrom = 11.3, kVentTo = 15.7;
/// Half the width of a vent in diameters of the envelope. Chosen by eye.
constexpr double kVentHalf = 0.0022;
/// The distance of a vent's flaps from the fabric in metres. Chosen by eye.
constexpr double kVentGap = 0.012;
/// The tolerance in metres from which vents are left out. Chosen by eye.
constexpr double kThinnestVent = 0.03;
/// The albedos of the valve lines, the sandbags and the pouches. Chosen by eye.
const vec3 kLineRed{0.45f, 0.02f, 0.02f};
const vec3 kCanvas{0.40f, 0.34f, 0.23f};
const vec3 kPouch{0.20f, 0.165f, 0.105f};

void add_vent(TriangleMesh& mesh, const EnvelopeShape& shape, int gore, const vec3& color,
              double gap) {
  constexpr int kRows = 18;
  const double panel = (shape.disc_arc() - shape.mouth_arc()) / shape.panels();
  const double turn = 2.0 * kPi / shape.gores();
  for (const double side : {1.0, -1.0}) {
    add_grid(mesh, {2, kRows}, [&](int i, int j) {
      const double along = static_cast<double>(j) / kRows;
      const double up = kVentFrom + (kVentTo - kVentFrom) * along;
      const EnvelopeRow row{shape.mouth_arc() + panel * up, up - std::floor(up)};
      const double half = kVentHalf * shape.diameter() * (0.12 + std::sin(kPi * along));
      const double share = 0.5 + side * (i - 1) * half / (turn * 0.5 * shape.diameter());
      const FabricPoint point = shape.fabric(gore, share, row);
      mesh.uvs.emplace_back(gore + 0.5, 13.5);
      return Vertex{point.position + side * gap * point.normal, side * point.normal, color};
    });
  }
}

/// Adds a padded box with rounded edges. It is a sphere whose directions are drawn towards those of
/// a box.
void add_pillow(TriangleMesh& mesh, const dvec3& center, const dvec3& half, const vec3& color) {
  constexpr int kAround = 28, kUp = 14;
  const auto drawn = [](double x) { return std::copysign(std::pow(std::abs(x), 0.45), x); };
  const auto surface = [&](double u, double v) {
    const double around = 2.0 * kPi * u, up = kPi * (v - 0.5);
    return center + half * dvec3(drawn(std::cos(up)) * drawn(std::cos(around)), drawn(std::sin(up)),
                                 -drawn(std::cos(up)) * drawn(std::sin(around)));
  };
  // The poles are the rims of small holes, drawn together. The rows of the grid end just beside
  // them.
  add_grid(mesh, {kAround, kUp, true, false}, [&](int i, int j) {
    const double u = (i + 0.5) / kAround, v = 0.004 + 0.992 * j / kUp;
    return Vertex{surface(u, v), surface_normal(surface, u, v, 1e-3), color};
  });
  for (const double v : {0.004, 0.996}) {
    const bool top = v > 0.5;
    const dvec3 up(0.0, top ? 1.0 : -1.0, 0.0);
    const std::uint32_t hub = add_vertex(mesh, {center + half * up, up, color});
    for (int i = 0; i < kAround; ++i)
      add_vertex(mesh, {surface((i + 0.5) / kAround, v), up, color});
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const std::uint32_t a = hub + 1 + i, b = hub + 1 + (i + 1) % kAround;
      top ? mesh.triangles.emplace_back(hub, a, b) : mesh.triangles.emplace_back(hub, b, a);
    }
  }
}

/// Adds a canvas pouch with a flap over its upper third.
void add_pouch(TriangleMesh& mesh, const dvec3& center, const dvec3& half) {
  add_pillow(mesh, center, half, kPouch);
  add_pillow(mesh, center + dvec3(0.0, 0.45 * half.y, 0.0),
             dvec3(half.x + 0.005, 0.58 * half.y, half.z + 0.005), kPouch * 0.72f);
}

}  // namespace

void add_vents(TriangleMesh& mesh, const EnvelopeShape& shape, const EnvelopePattern& pattern,
               const Detail& detail) {
  if (detail.envelope_m > kThinnestVent) return;
  const int first = shape.gores() / 8;
  for (const int gore : {first, first + shape.gores() / 2}) {
    add_vent(mesh, shape, gore, pattern.tape(), kVentGap + 1.5 * detail.envelope_m);
  }
}

void add_valve_lines(TriangleMesh& mesh, const EnvelopeShape& shape, double mouth_height_m,
                     const Detail& detail) {
  const double thin = seen_radius(0.003, detail);
  const int sides = sides_within(detail.basket_m, thin, 3, 6);
  const dvec3 base(0.0, mouth_height_m, 0.0);
  const dvec3 knot = base + dvec3(0.0, shape.height() - 0.19 * shape.diameter(), 0.0);
  const EnvelopeRow rim{shape.disc_arc(), 1.0};
  for (int gore = 0; gore < shape.gores(); gore += 2) {
    const dvec3 end = base + shape.fabric(gore, 0.0, rim).position;
    add_rod(mesh, glm::mix(knot, end, 0.01), end, thin, sides, vec3(0.5f));
  }
  add_rod(mesh, dvec3(0.27, kFrameHeight - 0.25, 0.05), knot, 1.3 * thin, sides, kLineRed);
}

void add_sandbags(TriangleMesh& mesh, const Detail& detail) {
  const Outline wall = wall_outline();
  const double quarter = wall.length() / 4.0, r = 0.075;
  const double out = kWallHalfThickness + weave_relief() + r;
  const int sides = sides_within(detail.basket_m, r, 6, 24);
  const std::array<dvec2, 9> sack{{{0.0, 0.0},
                                   {0.7 * r, 0.004},
                                   {0.96 * r, 0.035},
                                   {r, 0.09},
                                   {0.94 * r, 0.16},
                                   {0.70 * r, 0.205},
                                   {0.26 * r, 0.225},
                                   {0.40 * r, 0.262},
                                   {0.0, 0.258}}};
  for (int side = 0; side < 4; ++side) {
    const Outline::Point place = wall.at(side * quarter);
    const dvec3 foot = place.position + out * place.normal + dvec3(0.0, 0.60, 0.0);
    const auto tint = static_cast<float>(0.85 + 0.3 * hash_unit(side + 3u, 41u));
    add_lathe(mesh, foot, sack, sides,
              [tint](std::size_t i) { return kCanvas * (i == 6 ? 0.5f * tint : tint); });
    add_rod(mesh, foot + dvec3(0.0, 0.22, 0.0),
            place.position + (out - 0.03) * place.normal + dvec3(0.0, kRimHeight - 0.02, 0.0),
            seen_radius(0.006, detail), sides_within(detail.basket_m, 0.006, 4, 8), kCanvas * 0.7f);
  }
}

void add_pouches(TriangleMesh& mesh, const Detail& detail) {
  if (detail.basket_m > 0.01) return;
  const Outline wall = wall_outline();
  const double inside = kWallHalfThickness + weave_relief();
  add_pouch(mesh, {wall.half.x - inside - 0.032, 0.86, -0.12}, {0.030, 0.105, 0.15});
  add_pouch(mesh, {0.22, 0.885, -wall.half.y + inside + 0.026}, {0.095, 0.085, 0.026});
}

}  // namespace aerostat::model
