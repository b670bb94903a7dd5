#include "model/rim.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "model/dimensions.hpp"
#include "model/shapes.hpp"

namespace aerostat::model {
namespace {

using mesh::TriangleMesh;

constexpr double kPi = std::numbers::pi;
/// Half the width and half the height of the rim in metres. Chosen by eye.
constexpr double kHalfWidth = 0.050;
constexpr double kHalfHeight = 0.045;
/// The number of pieces of leather around the rim.
constexpr int kLengths = 12;
constexpr int kMostSides = 28;
/// The tolerance in metres from which stitches and seams are left out.
constexpr double kStitchFrom = 0.001;
/// The depth and the reach of a seam, and the distance between stitches, in metres. Chosen by eye.
constexpr double kSeamDepth = 0.0045;
constexpr double kSeamReach = 0.009;
constexpr double kStitchSpacing = 0.011;
const vec3 kThread{0.34f, 0.27f, 0.17f};

struct RimSurface {
  Outline middle;
  double height;

  double piece() const { return middle.length() / kLengths; }

  /// Returns the distance to the nearest cross seam in metres.
  double from_seam(double distance) const {
    return std::abs(distance - std::round(distance / piece()) * piece());
  }

  /// Returns a point of the rim. `across` is an angle that is 0 on the outer side and pi / 2 on
  /// top.
  dvec3 at(double distance, double across) const {
    const Outline::Point point = middle.at(distance);
    const double seam = from_seam(distance) / kSeamReach;
    const double drawn_in = kSeamDepth * std::exp(-seam * seam);
    return point.position + (kHalfWidth - drawn_in) * std::cos(across) * point.normal +
           dvec3(0.0, height + (kHalfHeight - drawn_in) * std::sin(across), 0.0);
  }

  dvec3 normal(double distance, double across) const {
    const auto surface = [this](double u, double v) { return at(u, v); };
    return surface_normal(surface, distance, across, 1e-4);
  }

  vec3 color(double distance) const {
    const auto piece_index = static_cast<std::uint32_t>(distance / piece());
    const double seam = from_seam(distance) / kSeamReach;
    const double tint = 0.86 + 0.28 * hash_unit(piece_index, 31u);
    return kLeather * static_cast<float>(tint * (1.0 - 0.6 * std::exp(-2.0 * seam * seam)));
  }
};

/// Returns sample distances along the rim, in metres. They are close together at the seams of the
/// leather, where the padding is drawn in.
std::vector<double> sample_places(double piece) {
  std::vector<double> places;
  constexpr std::array<double, 6> kNear{0.0, 0.003, 0.006, 0.010, 0.015, 0.022};
  const int even = static_cast<int>(std::lround((piece - 0.044) / 0.020));
  for (int k = 0; k < kLengths; ++k) {
    for (const double near : kNear) places.push_back(k * piece + near);
    for (int i = 1; i <= even; ++i) {
      places.push_back(k * piece + 0.022 + (piece - 0.044) * i / even);
    }
    for (std::size_t i = kNear.size() - 2; i > 0; --i) {
      places.push_back((k + 1) * piece - kNear[i]);
    }
  }
  return places;
}

std::vector<double> even_places(double length, int count) {
  std::vector<double> places;
  for (int i = 0; i < count; ++i) places.push_back(length * i / count);
  return places;
}

/// Adds a single stitch as a small spindle that lies on the leather.
void add_stitch(TriangleMesh& mesh, const dvec3& center, const dvec3& along, const dvec3& out) {
  const dvec3 side = glm::cross(out, along);
  const std::array<dvec3, 3> axes{along * 0.0038, side * 0.0013, out * 0.0013};
  std::uint32_t first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const dvec3& axis : axes) {
    for (const double sign : {1.0, -1.0}) {
      add_vertex(mesh, {center + sign * axis, sign * glm::normalize(axis), kThread});
    }
  }
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    const std::uint32_t a = first + (octant & 1u), b = first + 2 + ((octant >> 1) & 1u);
    const std::uint32_t c = first + 4 + ((octant >> 2) & 1u);
    const bool mirrored = ((octant ^ (octant >> 1) ^ (octant >> 2)) & 1u) != 0;
    mirrored ? mesh.triangles.emplace_back(a, c, b) : mesh.triangles.emplace_back(a, b, c);
  }
}

void add_stitch_row(TriangleMesh& mesh, const RimSurface& rim, double across) {
  const int count = static_cast<int>(std::lround(rim.middle.length() / kStitchSpacing));
  for (int i = 0; i < count; ++i) {
    const double distance = rim.middle.length() * (i + 0.5) / count;
    if (rim.from_seam(distance) < kSeamReach) continue;
    add_stitch(mesh, rim.at(distance, across), rim.middle.at(distance).tangent,
               rim.normal(distance, across));
  }
}

}  // namespace

dvec2 rim_half_size() {
  return {kHalfWidth, kHalfHeight};
}

TriangleMesh build_rim(const Outline& middle, double height, const Detail& detail) {
  const RimSurface rim{middle, height};
  const bool plain = detail.basket_m >= kStitchFrom;
  const std::vector<double> places =
      plain ? even_places(middle.length(), 48) : sample_places(rim.piece());
  const int sides = sides_within(detail.basket_m, kHalfWidth, 6, kMostSides);
  const int columns = static_cast<int>(places.size());
  // The grid has one more line in each direction, because the first and the last vertex of a
  // closed line have different uvs at the same place.
  TriangleMesh mesh;
  add_grid(mesh, {columns, sides}, [&](int i, int j) {
    const double distance = places[static_cast<std::size_t>(i % columns)];
    const double across = 2.0 * kPi * (j % sides) / sides;
    mesh.uvs.emplace_back(i == columns ? middle.length() : distance,
                          0.5 * (kHalfWidth + kHalfHeight) * 2.0 * kPi * j / sides);
    return Vertex{rim.at(distance, across), rim.normal(distance, across), rim.color(distance)};
  });
  if (plain) return mesh;
  mesh::TriangleMesh stitches;
  add_stitch_row(stitches, rim, kPi * 0.22);
  add_stitch_row(stitches, rim, kPi * 0.78);
  mesh::append(mesh, stitches);
  return mesh;
}

}  // namespace aerostat::model
