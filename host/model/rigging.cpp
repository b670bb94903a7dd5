#include "model/rigging.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/burner.hpp"
#include "model/dimensions.hpp"
#include "model/fittings.hpp"
#include "model/shapes.hpp"

namespace aerostat::model {
namespace {

using mesh::TriangleMesh;

/// The radii of wires, tubes, sleeves and hoses in metres. Chosen by eye.
constexpr double kFlyingWireRadius = 0.0030;
constexpr double kBasketWireRadius = 0.0032;
constexpr double kMouthRingRadius = 0.012;
constexpr double kFrameTube = 0.019;
constexpr double kSleeveRadius = 0.031;
constexpr double kHoseRadius = 0.009;
const vec3 kWireColor{0.20f, 0.205f, 0.215f};
const std::array<dvec2, 4> kCorners{dvec2(1.0, -1.0), dvec2(-1.0, -1.0), dvec2(-1.0, 1.0),
                                    /// The signs of the four corners, counter-clockwise as seen
                                    /// from above.
                                    dvec2(1.0, 1.0)};

dvec3 frame_corner(const dvec2& sign) {
  return {sign.x * kFrameHalf.x, kFrameHeight, sign.y * kFrameHalf.y};
}

/// An upright, which leans from the basket's corner to the corner of the frame.
struct Upright {
  dvec3 foot, head;

  explicit Upright(const dvec2& sign)
      : foot(wall_outline().corner(sign.x, sign.y) + dvec3(0.0, kRimHeight - 0.02, 0.0)),
        head(frame_corner(sign)) {}

  dvec3 at(double share) const { return glm::mix(foot, head, share); }
};

/// A sleeve of leather over padding, drawn in at both ends and held by straps. It leaves the upper
/// end of the upright bare, and the hose runs inside it.
struct Sleeve {
  static constexpr double kTo = 0.93, kLaced = 0.035, kStraps = 3.0;
  Upright upright;

  double length() const { return glm::distance(upright.foot, upright.head); }

  /// Returns how much a strap draws the padding in: 1 under a strap, and 0 away from it. Straps are
  /// 3 cm wide.
  double drawn_in(double share) const {
    const double place = share / kTo * kStraps - 0.5;
    const double away_m = (place - std::round(place)) * kTo / kStraps * length();
    return std::exp(-std::pow(away_m / 0.015, 4.0));
  }

  double radius(double share) const {
    const double end = std::clamp(std::min(share, kTo - share) / kLaced, 0.0, 1.0);
    const double full = 0.66 + 0.34 * std::sin(0.5 * std::numbers::pi * end);
    return kSleeveRadius * full * (1.0 - 0.10 * drawn_in(share));
  }

  /// Returns a point of the sleeve. `u` is a turn around the upright, and `v` a share of its
  /// length.
  dvec3 at(double u, double v) const {
    const dvec3 axis = glm::normalize(upright.head - upright.foot);
    const dvec3 side = glm::normalize(glm::cross(axis, dvec3(0.0, 0.0, 1.0)));
    const double angle = 2.0 * std::numbers::pi * u;
    return upright.at(v) +
           radius(v) * (side * std::cos(angle) + glm::cross(axis, side) * std::sin(angle));
  }
};

/// Closes an end of a sleeve with a disc.
void add_sleeve_end(TriangleMesh& mesh, const Sleeve& sleeve, double share, int sides) {
  const dvec3 axis = glm::normalize(sleeve.upright.head - sleeve.upright.foot);
  const bool top = share > 0.0;
  const dvec3 out = top ? axis : -axis;
  const vec3 color = kLeather * 0.4f;
  const std::uint32_t hub = add_vertex(mesh, {sleeve.upright.at(share), out, color});
  for (int i = 0; i < sides; ++i) {
    add_vertex(mesh, {sleeve.at(static_cast<double>(i) / sides, share), out, color});
  }
  const auto count = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t a = hub + 1 + i, b = hub + 1 + (i + 1) % count;
    top ? mesh.triangles.emplace_back(hub, a, b) : mesh.triangles.emplace_back(hub, b, a);
  }
}

/// Adds a sleeve. The uvs of its vertices are metres along and around it.
void add_sleeve(TriangleMesh& mesh, const Upright& upright, double tolerance_m) {
  const Sleeve sleeve{upright};
  const auto surface = [&](double u, double v) { return sleeve.at(u, v); };
  const int sides = sides_within(tolerance_m, kSleeveRadius, 5, 24);
  const int rows = tolerance_m >= 0.004 ? 4 : 90;
  TriangleMesh cloth;
  add_grid(cloth, {sides, rows}, [&](int i, int j) {
    const double u = static_cast<double>(i % sides) / sides, v = Sleeve::kTo * j / rows;
    cloth.uvs.emplace_back(sleeve.length() * v, 2.0 * std::numbers::pi * kSleeveRadius * i / sides);
    const auto shade = static_cast<float>(1.0 - 0.6 * sleeve.drawn_in(v));
    return Vertex{sleeve.at(u, v), surface_normal(surface, u, v, 2e-3), kLeather * shade};
  });
  add_sleeve_end(cloth, sleeve, 0.0, sides);
  add_sleeve_end(cloth, sleeve, Sleeve::kTo, sides);
  cloth.uvs.resize(cloth.positions.size(), vec2(0.0f));
  mesh::append(mesh, cloth);
}

void add_frame_tubes(TriangleMesh& mesh, double tolerance_m) {
  const int sides = sides_within(tolerance_m, kFrameTube, 4, 16);
  // The corner pieces cover the ends of the tubes, so the tubes are shortened by this length in
  // metres.
  constexpr double kShort = 0.012;
  for (std::size_t i = 0; i < kCorners.size(); ++i) {
    const dvec3 corner = frame_corner(kCorners[i]);
    const dvec3 next = frame_corner(kCorners[(i + 1) % kCorners.size()]);
    const dvec3 along = kShort * glm::normalize(next - corner);
    add_rod(mesh, corner + along, next - along, kFrameTube, sides, kSteel);
    add_sphere(mesh, corner, 0.034, sides_within(tolerance_m, 0.034, 6, 20), kSteel * 0.8f);
  }
  for (const double z : {-burner_mount_z(), burner_mount_z()}) {
    add_rod(mesh, {-kFrameHalf.x, kFrameHeight, z}, {kFrameHalf.x, kFrameHeight, z}, kFrameTube,
            sides, kSteel);
  }
}

/// Returns a curve from `from` to `to` that leaves along `leave` and arrives along `arrive`.
std::vector<dvec3> bent_path(const dvec3& from, const dvec3& leave, const dvec3& arrive,
                             const dvec3& to, int points) {
  std::vector<dvec3> path;
  for (int i = 0; i < points; ++i) {
    const double t = static_cast<double>(i) / (points - 1), s = 1.0 - t;
    path.push_back(s * s * s * from + 3.0 * s * s * t * (from + leave) +
                   3.0 * s * t * t * (to - arrive) + t * t * t * to);
  }
  return path;
}

/// Adds the hoses, which rise from the cylinders into the sleeves of the uprights and leave them
/// for the burners.
void add_hoses(TriangleMesh& mesh, double tolerance_m) {
  const int points = 4 * steps_within(tolerance_m, 0.2, 6) + 1;
  const int sides = sides_within(tolerance_m, kHoseRadius, 4, 10);
  for (const dvec2& sign : kCorners) {
    const Upright upright(sign);
    const dvec3 axis = glm::normalize(upright.head - upright.foot);
    const dvec3 inwards = glm::normalize(dvec3(-sign.x, 0.0, -sign.y));
    const dvec3 inside = 0.5 * kSleeveRadius * inwards;
    const dvec3 valve(sign.x * kCylinderPlace.x, kCylinderHeight + 0.03, sign.y * kCylinderPlace.y);
    const dvec3 low = upright.at(0.10) + inside, high = upright.at(0.86) + inside;
    const dvec3 port(sign.x * burner_port().x, burner_port().y, sign.y * burner_port().z);
    add_tube(mesh, bent_path(valve, {0.0, 0.16, 0.0}, 0.16 * axis, low, points), kHoseRadius, sides,
             kBlackRubber);
    add_tube(mesh, bent_path(high, 0.16 * axis, {0.0, 0.0, -sign.y * 0.14}, port, points),
             kHoseRadius, sides, kBlackRubber);
  }
}

void add_wire(TriangleMesh& mesh, const Wire& wire, const Detail& detail) {
  const double radius = seen_radius(wire.radius, detail);
  add_rod(mesh, wire.from, wire.to, radius, sides_within(detail.basket_m, radius, 4, 8),
          kWireColor);
}

}  // namespace

double mouth_height(double diameter_m) {
  return 2.9 + 0.095 * diameter_m;
}

std::vector<Wire> flying_wires(const EnvelopeShape& shape) {
  std::vector<Wire> wires;
  const double y = mouth_height(shape.diameter());
  for (int tape = 0; tape < shape.gores(); ++tape) {
    const double angle = shape.tape_angle(tape);
    const auto corner = std::min<std::size_t>(
        static_cast<std::size_t>(4.0 * angle / (2.0 * std::numbers::pi)) % 4, 3);
    const dvec3 mouth(shape.mouth_radius() * std::cos(angle), y,
                      -shape.mouth_radius() * std::sin(angle));
    wires.push_back({frame_corner(kCorners[corner]), mouth, kFlyingWireRadius});
  }
  return wires;
}

std::vector<Wire> basket_wires() {
  // The distance of a wire's foot from the basket's corner along the rim, in metres. Chosen by eye.
  constexpr double kSpread = 0.30;
  std::vector<Wire> wires;
  const Outline wall = wall_outline();
  const double quarter = wall.length() / 4.0;
  for (std::size_t i = 0; i < kCorners.size(); ++i) {
    // The outline starts in the middle of +x. Its first corner would be halfway along the first
    // quarter if the half sides were equal.
    const double lead = (i % 2 == 0 ? wall.half.y : wall.half.x) - wall.corner_radius;
    const double corner =
        static_cast<double>(i) * quarter + lead + wall.corner_radius * std::numbers::pi / 4.0;
    for (const double side : {-kSpread, kSpread}) {
      const dvec3 foot = wall.at(corner + side).position + dvec3(0.0, kRimHeight, 0.0);
      wires.push_back({frame_corner(kCorners[i]), foot, kBasketWireRadius});
    }
  }
  return wires;
}

double clear_radius(const std::vector<Wire>& wires, double y) {
  double clear = std::numeric_limits<double>::max();
  for (const Wire& wire : wires) {
    const double t = (y - wire.from.y) / (wire.to.y - wire.from.y);
    const dvec3 point = glm::mix(wire.from, wire.to, std::clamp(t, 0.0, 1.0));
    clear = std::min(clear, std::hypot(point.x, point.z) - wire.radius);
  }
  return clear;
}

TriangleMesh build_cables(const EnvelopeShape& shape, const Detail& detail) {
  TriangleMesh mesh;
  for (const Wire& wire : flying_wires(shape)) add_wire(mesh, wire, detail);
  for (const Wire& wire : basket_wires()) add_wire(mesh, wire, detail);
  add_valve_lines(mesh, shape, mouth_height(shape.diameter()), detail);
  const double ring = seen_radius(kMouthRingRadius, detail);
  add_torus(mesh, {0.0, mouth_height(shape.diameter()), 0.0}, shape.mouth_radius(), ring,
            sides_within(detail.basket_m, shape.mouth_radius(), shape.gores(), shape.gores() * 8),
            sides_within(detail.basket_m, ring, 4, 10), kWireColor);
  return mesh;
}

TriangleMesh build_padding(const Detail& detail) {
  TriangleMesh mesh;
  for (const dvec2& sign : kCorners) {
    add_sleeve(mesh, Upright(sign), detail.basket_m);
    add_jacket(mesh, {sign.x * kCylinderPlace.x, 0.0, sign.y * kCylinderPlace.y}, detail);
  }
  add_pouches(mesh, detail);
  return mesh;
}

TriangleMesh build_frame(const Detail& detail) {
  TriangleMesh mesh;
  for (const dvec2& sign : kCorners) {
    const Upright upright(sign);
    add_rod(mesh, upright.foot, upright.head, 0.014, sides_within(detail.basket_m, 0.014, 4, 12),
            kSteel);
    add_cylinder(mesh, {sign.x * kCylinderPlace.x, 0.0, sign.y * kCylinderPlace.y}, detail);
  }
  add_frame_tubes(mesh, detail.basket_m);
  add_burners(mesh, detail);
  add_hoses(mesh, detail.basket_m);
  return mesh;
}

}  // namespace aerostat::model
