#include "model/rigging.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/burner.hpp"
#include "model/dimensions.hpp"
#include "model/shapes.hpp"

namespace aerostat::model {
namespace {

using mesh::TriangleMesh;

constexpr double kFlyingWireRadius = 0.008;
constexpr double kBasketWireRadius = 0.006;
constexpr double kMouthRingRadius = 0.022;
constexpr double kFrameTube = 0.019;
constexpr double kSleeveRadius = 0.033;
const vec3 kWireColor{0.23f, 0.235f, 0.245f};
const std::array<dvec2, 4> kCorners{dvec2(1.0, -1.0), dvec2(-1.0, -1.0), dvec2(-1.0, 1.0),
                                    dvec2(1.0, 1.0)};  // counter-clockwise from above

dvec3 frame_corner(const dvec2& sign) {
  return {sign.x * kFrameHalf.x, kFrameHeight, sign.y * kFrameHalf.y};
}

/// An upright leans from the basket's corner to the frame's.
struct Upright {
  dvec3 foot, head;

  explicit Upright(const dvec2& sign)
      : foot(wall_outline().corner(sign.x, sign.y) + dvec3(0.0, kRimHeight - 0.02, 0.0)),
        head(frame_corner(sign)) {}

  dvec3 at(double share) const { return glm::mix(foot, head, share); }
};

/// The padded sleeve leaves the upright's upper end bare; straps draw it in.
void add_upright(TriangleMesh& mesh, const Upright& upright) {
  add_rod(mesh, upright.foot, upright.head, 0.014, 12, kSteel);
  struct Ring {
    double share, radius;
    vec3 color;
  };
  std::vector<Ring> rings{{0.0, kSleeveRadius, kLeather}};
  for (const double strap : {0.16, 0.44, 0.72}) {
    for (const double side : {-1.0, 1.0}) {
      const double edge = strap + side * 0.011;
      const Ring padding{edge + side * 0.016, kSleeveRadius, kLeather};
      const Ring pressed{edge + side * 0.004, 0.90 * kSleeveRadius, kLeather * 0.6f};
      const Ring tight{edge, 0.87 * kSleeveRadius, kLeather * 0.25f};
      if (side < 0.0) rings.insert(rings.end(), {padding, pressed, tight});
      if (side > 0.0) rings.insert(rings.end(), {tight, pressed, padding});
    }
  }
  rings.insert(rings.end(), {{0.915, kSleeveRadius, kLeather},
                             {0.928, 0.90 * kSleeveRadius, kLeather * 0.8f},
                             {0.932, 0.60 * kSleeveRadius, kLeather * 0.5f}});
  std::vector<dvec3> path;
  for (const Ring& ring : rings) path.push_back(upright.at(ring.share));
  add_tube(mesh, {path, 20, [&](std::size_t i) { return rings[i].radius; },
                  [&](std::size_t i) { return rings[i].color; }});
}

void add_frame_tubes(TriangleMesh& mesh) {
  constexpr double kShort = 0.012;  // the corner pieces take the tubes' ends in
  for (std::size_t i = 0; i < kCorners.size(); ++i) {
    const dvec3 corner = frame_corner(kCorners[i]);
    const dvec3 next = frame_corner(kCorners[(i + 1) % kCorners.size()]);
    const dvec3 along = kShort * glm::normalize(next - corner);
    add_rod(mesh, corner + along, next - along, kFrameTube, 16, kSteel);
    add_sphere(mesh, corner, 0.034, 20, kSteel * 0.8f);
  }
  for (const double z : {-burner_mount_z(), burner_mount_z()}) {
    add_rod(mesh, {-kFrameHalf.x, kFrameHeight, z}, {kFrameHalf.x, kFrameHeight, z}, kFrameTube, 16,
            kSteel);
  }
}

/// A curve from `from` to `to` that leaves along `leave` and arrives along `arrive`.
std::vector<dvec3> bent_path(const dvec3& from, const dvec3& leave, const dvec3& arrive,
                             const dvec3& to) {
  constexpr int kPoints = 25;
  std::vector<dvec3> path;
  for (int i = 0; i < kPoints; ++i) {
    const double t = static_cast<double>(i) / (kPoints - 1), s = 1.0 - t;
    path.push_back(s * s * s * from + 3.0 * s * s * t * (from + leave) +
                   3.0 * s * t * t * (to - arrive) + t * t * t * to);
  }
  return path;
}

/// Hoses rise from the cylinders, follow the uprights on their inner side and cross to the burners.
void add_hoses(TriangleMesh& mesh) {
  for (const dvec2& sign : kCorners) {
    const Upright upright(sign);
    const dvec3 axis = glm::normalize(upright.head - upright.foot);
    const dvec3 inwards = glm::normalize(dvec3(-sign.x, 0.0, -sign.y));
    const dvec3 beside = (kSleeveRadius + 0.011) * inwards;
    const dvec3 valve(sign.x * kCylinderPlace.x, kCylinderHeight + 0.03, sign.y * kCylinderPlace.y);
    const dvec3 low = upright.at(0.20) + beside, high = upright.at(0.84) + beside;
    const dvec3 port(sign.x * burner_port().x, burner_port().y, sign.y * burner_port().z);
    std::vector<dvec3> path = bent_path(valve, {0.0, 0.22, 0.0}, 0.18 * axis, low);
    const std::vector<dvec3> rest = bent_path(high, 0.16 * axis, {0.0, 0.0, -sign.y * 0.14}, port);
    path.insert(path.end(), rest.begin(), rest.end());
    add_tube(mesh, path, 0.010, 10, kBlackRubber);
  }
}

void add_wire(TriangleMesh& mesh, const Wire& wire) {
  add_rod(mesh, wire.from, wire.to, wire.radius, 8, kWireColor);
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
  constexpr double kSpread = 0.30;  // along the rim, from the basket's corner
  std::vector<Wire> wires;
  const Outline wall = wall_outline();
  const double quarter = wall.length() / 4.0;
  for (std::size_t i = 0; i < kCorners.size(); ++i) {
    // The outline starts in the middle of +x; its first corner is halfway along the first quarter,
    // but for the difference of the half sides.
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

TriangleMesh build_cables(const EnvelopeShape& shape) {
  TriangleMesh mesh;
  for (const Wire& wire : flying_wires(shape)) add_wire(mesh, wire);
  for (const Wire& wire : basket_wires()) add_wire(mesh, wire);
  add_torus(mesh, {0.0, mouth_height(shape.diameter()), 0.0}, shape.mouth_radius(),
            kMouthRingRadius, shape.gores() * 8, 10, kWireColor);
  return mesh;
}

TriangleMesh build_frame() {
  TriangleMesh mesh;
  for (const dvec2& sign : kCorners) {
    add_upright(mesh, Upright(sign));
    add_cylinder(mesh, {sign.x * kCylinderPlace.x, 0.0, sign.y * kCylinderPlace.y});
  }
  add_frame_tubes(mesh);
  add_burners(mesh);
  add_hoses(mesh);
  return mesh;
}

}  // namespace aerostat::model
