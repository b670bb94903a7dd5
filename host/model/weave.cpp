#include "model/weave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/shapes.hpp"

namespace aerostat::model {
namespace {

using mesh::TriangleMesh;

constexpr double kPi = std::numbers::pi;
/// The distance between stakes and the height of a weaver in metres. Chosen by eye.
constexpr double kStakePitch = 0.034;
constexpr double kWeaverHeight = 0.0095;
/// Half the thickness of a weaver in metres. Chosen by eye.
constexpr double kRound = 0.0022;
/// The distance in metres by which a weaver bends around a stake. Chosen by eye.
constexpr double kSway = 0.0030;
/// The tolerance in metres from which the wall has no relief.
constexpr double kPlainFrom = 0.002;
/// The length of a willow rod in metres. Chosen by eye.
constexpr double kSplice = 1.1;
constexpr float kMeanShade = 0.72f;
/// The albedos of the willow rods. Chosen by eye.
const vec3 kHoney{0.54f, 0.35f, 0.165f};
const vec3 kPale{0.62f, 0.44f, 0.23f};
const vec3 kRusset{0.40f, 0.235f, 0.115f};

/// Returns the colour of the rod at a place of the wall. The colours vary at random, because nobody
/// sorts the rods.
vec3 rod_color(int weaver, double distance) {
  const auto row = static_cast<std::uint32_t>(weaver);
  const double first = kSplice * hash_unit(row, 3u);
  const auto rod = static_cast<std::uint32_t>(std::floor((distance + first) / kSplice));
  const auto hue = static_cast<float>(hash_unit(row * 64u + rod, 17u));
  const auto tint = static_cast<float>(0.80 + 0.34 * hash_unit(row * 64u + rod, 29u));
  const vec3 color = hue < 0.5f ? glm::mix(kHoney, kPale, 1.6f * hue)
                                : glm::mix(kHoney, kRusset, 1.3f * (hue - 0.5f));
  return color * tint;
}

/// One face of the wall. `side` is 1 for the outer face and -1 for the inner one.
struct Face {
  Outline middle;
  double bottom, weaver_height, half_thickness, side;
  int stakes;

  /// Returns the height in metres by which a weaver stands out from the wall. It is 0 at the edges
  /// of the weaver, where it meets its neighbours.
  double relief(int weaver, double stake, double up) const {
    const double over = side * (weaver % 2 == 0 ? 1.0 : -1.0) * std::cos(kPi * stake);
    return std::sin(kPi * up) * (kRound + kSway * over);
  }

  /// Returns a point of the face. `stake` counts stakes along the outline, and `up` runs from 0 to
  /// 1 across the weaver.
  dvec3 at(int weaver, double stake, double up) const {
    const Outline::Point point = middle.at(stake / stakes * middle.length());
    const double out = side * (half_thickness + relief(weaver, stake, up));
    return point.position + out * point.normal +
           dvec3(0.0, bottom + (weaver + up) * weaver_height, 0.0);
  }

  /// Returns the normal of the face. It is computed as if a weaver went on beyond its edges, so
  /// that the grooves stay sharp.
  dvec3 normal(int weaver, double stake, double up) const {
    const double over = side * (weaver % 2 == 0 ? 1.0 : -1.0);
    const double sway = kSway * over * std::cos(kPi * stake);
    const double per_stake = -kPi * kSway * over * std::sin(kPi * stake) * std::sin(kPi * up);
    const double per_up = kPi * std::cos(kPi * up) * (kRound + sway);
    const Outline::Point point = middle.at(stake / stakes * middle.length());
    const double along = per_stake * stakes / middle.length();
    return side * point.normal - along * point.tangent - dvec3(0.0, per_up / weaver_height, 0.0);
  }

  Vertex vertex(int weaver, double stake, double up) const {
    const double shown = relief(weaver, stake, up) / (kRound + kSway);
    const double shade = 0.36 + 0.64 * std::pow(std::clamp(shown, 0.0, 1.0), 0.6);
    return {at(weaver, stake, up), normal(weaver, stake, up),
            rod_color(weaver, stake / stakes * middle.length()) * static_cast<float>(shade)};
  }
};

/// Adds a face of the wall. The outside of a mesh is where columns x rows points, so the columns of
/// an inner face run in the opposite direction.
void add_face(TriangleMesh& mesh, const Face& face, int weavers, int per_stake) {
  constexpr int kCellsPerWeaver = 2;
  const int columns = face.stakes * per_stake;
  for (int weaver = 0; weaver < weavers; ++weaver) {
    add_grid(mesh, {columns, kCellsPerWeaver, true, false}, [&](int i, int j) {
      const int along = face.side > 0.0 ? i : (columns - i) % columns;
      return face.vertex(weaver, static_cast<double>(along) / per_stake,
                         static_cast<double>(j) / kCellsPerWeaver);
    });
  }
}

/// Adds the narrow level strip that joins both faces at the top or the bottom.
void add_edge(TriangleMesh& mesh, const Face& outer, const Face& inner, int weaver, double up,
              int per_stake) {
  const bool top = up > 0.5;
  add_grid(mesh, {outer.stakes * per_stake, 1, true, false}, [&](int i, int j) {
    const double stake = static_cast<double>(i) / per_stake;
    const Face& face = (j == 0) == top ? outer : inner;
    return Vertex{face.at(weaver, stake, up), dvec3(0.0, top ? 1.0 : -1.0, 0.0), kHoney * 0.5f};
  });
}

/// Adds the wall as its four smooth sides, for a distance from which the weave is too fine to be
/// seen.
void add_plain_wall(TriangleMesh& mesh, const Outline& middle, double bottom, double top,
                    double half_thickness) {
  constexpr int kColumns = 48;
  const double half = half_thickness + 0.5 * (kRound + kSway);
  const auto strip = [&](double from_side, double from_y, double to_side, double to_y) {
    add_grid(mesh, {kColumns, 1, true, false}, [&](int i, int j) {
      const Outline::Point point = middle.at(middle.length() * i / kColumns);
      const double side = j == 0 ? from_side : to_side, y = j == 0 ? from_y : to_y;
      const dvec3 up(0.0, from_side > to_side ? 1.0 : -1.0, 0.0);
      return Vertex{point.position + side * half * point.normal + dvec3(0.0, y, 0.0),
                    from_side == to_side ? side * point.normal : up, kHoney * kMeanShade};
    });
  };
  strip(1.0, bottom, 1.0, top);
  strip(1.0, top, -1.0, top);
  strip(-1.0, top, -1.0, bottom);
  strip(-1.0, bottom, 1.0, bottom);
}

}  // namespace

double weave_relief() {
  return kRound + kSway;
}

void add_woven_wall(TriangleMesh& mesh, const Outline& middle, double bottom, double top,
                    double half_thickness, double tolerance_m) {
  if (tolerance_m >= kPlainFrom) return add_plain_wall(mesh, middle, bottom, top, half_thickness);
  const int per_stake = steps_within(tolerance_m, kSway, 2);
  const int weavers = std::max(1, static_cast<int>(std::lround((top - bottom) / kWeaverHeight)));
  const int stakes = 2 * static_cast<int>(std::lround(middle.length() / (2.0 * kStakePitch)));
  const double height = (top - bottom) / weavers;
  const Face outer{middle, bottom, height, half_thickness, 1.0, stakes};
  const Face inner{middle, bottom, height, half_thickness, -1.0, stakes};
  add_face(mesh, outer, weavers, per_stake);
  add_face(mesh, inner, weavers, per_stake);
  add_edge(mesh, outer, inner, weavers - 1, 1.0, per_stake);
  add_edge(mesh, outer, inner, 0, 0.0, per_stake);
}

void add_rope_band(TriangleMesh& mesh, const Outline& path, double offset, double height,
                   double radius, double tolerance_m) {
  // The relief of the strands as a share of the rope's radius. Chosen by eye.
  constexpr double kStrand = 0.16;
  const double length = path.length();
  const bool plain = tolerance_m >= kStrand * radius;
  const int turns = static_cast<int>(std::lround(length / (radius * 5.0)));
  const int columns = plain ? 48 : turns * (tolerance_m > 0.0 ? 4 : 6);
  const int sides = sides_within(tolerance_m, radius, 4, 8);
  const auto surface = [&](double u, double v) {
    const Outline::Point point = path.at(u * length);
    const double across = 2.0 * kPi * v;
    const double strand = plain ? 1.0 : 1.0 + kStrand * std::cos(2.0 * (across - kPi * turns * u));
    const dvec3 spoke = point.normal * std::cos(across) + dvec3(0.0, std::sin(across), 0.0);
    return point.position + offset * point.normal + dvec3(0.0, height, 0.0) +
           radius * strand * spoke;
  };
  add_grid(mesh, {columns, sides, true, true}, [&](int i, int j) {
    const double u = static_cast<double>(i) / columns, v = static_cast<double>(j) / sides;
    const double strand =
        plain ? 0.5 : 0.5 + 0.5 * std::cos(2.0 * (2.0 * kPi * v - kPi * turns * u));
    const vec3 color = kRusset * static_cast<float>(0.7 + 0.6 * strand);
    return Vertex{surface(u, v), surface_normal(surface, u, v, 1e-5), color};
  });
}

}  // namespace aerostat::model
