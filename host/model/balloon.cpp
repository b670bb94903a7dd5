#include "model/balloon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/basket.hpp"
#include "model/burner.hpp"
#include "model/dimensions.hpp"
#include "model/envelope.hpp"
#include "model/fittings.hpp"
#include "model/passengers.hpp"
#include "model/rigging.hpp"
#include "model/rim.hpp"

namespace aerostat::model {
namespace {

using mesh::TriangleMesh;
using scene::MaterialId;
using scene::ObjectId;

/// The depth of the skirt in diameters of the envelope. Chosen by eye.
constexpr double kSkirtDepth = 0.055;
/// The lower radius of the skirt as a share of the room between the wires. Chosen by eye.
constexpr double kSkirtClearance = 0.95;

/// Turns the model's axes (x right, y up, z back) to the heading and moves them to the balloon's
/// position.
struct Placement {
  dvec3 right, back, origin;

  explicit Placement(const scene::Balloon& balloon) : origin(balloon.position) {
    const double heading = balloon.heading_deg * std::numbers::pi / 180.0;
    right = {std::cos(heading), 0.0, std::sin(heading)};
    back = {-std::sin(heading), 0.0, std::cos(heading)};
  }

  dvec3 turned(const dvec3& v) const { return v.x * right + dvec3(0.0, v.y, 0.0) + v.z * back; }
  dvec3 placed(const dvec3& p) const { return origin + turned(p); }

  void apply(TriangleMesh& mesh) const {
    for (vec3& position : mesh.positions) position = vec3(placed(dvec3(position)));
    for (vec3& normal : mesh.normals) normal = glm::normalize(vec3(turned(dvec3(normal))));
  }
};

void raise(TriangleMesh& mesh, double height) {
  for (vec3& position : mesh.positions) position.y += static_cast<float>(height);
}

TriangleMesh hung_skirt(const EnvelopeShape& shape, const EnvelopePattern& pattern,
                        const Detail& detail) {
  const double depth = kSkirtDepth * shape.diameter();
  const double hem = mouth_height(shape.diameter()) - depth;
  const double room = kSkirtClearance * clear_radius(flying_wires(shape), hem);
  return build_skirt(shape, pattern, std::min(room, shape.mouth_radius()), depth, detail);
}

}  // namespace

std::vector<Part> balloon(const scene::Balloon& balloon, const Detail& detail) {
  const EnvelopeShape shape(balloon.diameter_m, balloon.gores);
  const EnvelopePattern pattern(balloon, shape.panels());
  std::vector<Part> parts;
  parts.push_back(
      {ObjectId::envelope, MaterialId::envelope, build_envelope(shape, pattern, detail)});
  add_vents(parts.back().mesh, shape, pattern, detail);
  parts.push_back({ObjectId::skirt, MaterialId::skirt, hung_skirt(shape, pattern, detail)});
  for (Part& part : parts) raise(part.mesh, mouth_height(shape.diameter()));
  parts.push_back({ObjectId::basket, MaterialId::basket, build_basket(detail)});
  parts.push_back({ObjectId::rim, MaterialId::rim, build_rim(wall_outline(), kRimHeight, detail)});
  mesh::append(parts.back().mesh, build_padding(detail));
  parts.push_back({ObjectId::frame, MaterialId::frame, build_frame(detail)});
  parts.push_back({ObjectId::cables, MaterialId::cables, build_cables(shape, detail)});
  parts.push_back({ObjectId::floor, MaterialId::floor, build_floor()});
  if (balloon.passengers > 0) {
    parts.push_back(
        {ObjectId::passenger, MaterialId::passenger, build_passengers(balloon.passengers, detail)});
  }
  if (balloon.burner > 0.0) {
    parts.push_back({ObjectId::flame, MaterialId::flame, build_flame(balloon.burner, detail)});
  }
  const Placement placement(balloon);
  for (Part& part : parts) placement.apply(part.mesh);
  return parts;
}

dvec3 basket_eye(const scene::Balloon& balloon) {
  return Placement(balloon).placed(kEye);
}

dvec3 basket_forward(const scene::Balloon& balloon) {
  return Placement(balloon).turned({0.0, 0.0, -1.0});
}

dvec3 flame_middle(const scene::Balloon& balloon) {
  return balloon.position + dvec3(0.0, flame_height(), 0.0);
}

double balloon_height(const scene::Balloon& balloon) {
  const EnvelopeShape shape(balloon.diameter_m, balloon.gores);
  return mouth_height(balloon.diameter_m) + shape.height();
}

}  // namespace aerostat::model
