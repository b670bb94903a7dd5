#include "model/weave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/shapes.hpp"

namespace aerostat::model {
namespace {

using mesh::TriangleMesh;

constexpr double kPi = std::numbers::pi;
constexpr double kStakePitch = 0.050;
constexpr double kWeaverHeight = 0.032;
constexpr int kCellsPerStake = 4;
constexpr int kCellsPerWeaver = 3;
constexpr double kRound = 0.0055;  // half a weaver's thickness
constexpr double kSway = 0.0050;   // how far it bends around a stake
const vec3 kCane{0.42f, 0.205f, 0.066f};

/// One face of the wall. `side` is 1 for the outer face, -1 for the inner one.
struct Face {
  Outline middle;
  double bottom, weaver_height, half_thickness, side;
  int stakes;

  /// A weaver stands out from the wall by this; at its edges it meets its neighbours at 0.
  double relief(int weaver, double stake, double up) const {
    const double over = side * (weaver % 2 == 0 ? 1.0 : -1.0) * std::cos(kPi * stake);
    return std::sin(kPi * up) * (kRound + kSway * over);
  }

  /// `stake` counts stakes along the outline, `up` runs from 0 to 1 across the weaver.
  dvec3 at(int weaver, double stake, double up) const {
    const Outline::Point point = middle.at(stake / stakes * middle.length());
    const double out = side * (half_thickness + relief(weaver, stake, up));
    return point.position + out * point.normal +
           dvec3(0.0, bottom + (weaver + up) * weaver_height, 0.0);
  }

  /// Taken as if a weaver went on beyond its edges, so that the grooves stay sharp.
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
    const auto row = static_cast<std::uint32_t>(weaver);
    const auto cell = static_cast<std::uint32_t>(std::lround(stake)) % stakes;
    const double tint = 0.72 + 0.30 * hash_unit(row, 7u) + 0.16 * hash_unit(row + 99u, cell);
    const double shade = 0.22 + 0.78 * std::pow(std::clamp(shown, 0.0, 1.0), 0.6);
    return {at(weaver, stake, up), normal(weaver, stake, up),
            kCane * static_cast<float>(tint * shade)};
  }
};

/// The mesh's outside is where columns x rows points: an inner face runs the other way round.
void add_face(TriangleMesh& mesh, const Face& face, int weavers) {
  const int columns = face.stakes * kCellsPerStake;
  for (int weaver = 0; weaver < weavers; ++weaver) {
    add_grid(mesh, {columns, kCellsPerWeaver, true, false}, [&](int i, int j) {
      const int along = face.side > 0.0 ? i : (columns - i) % columns;
      return face.vertex(weaver, static_cast<double>(along) / kCellsPerStake,
                         static_cast<double>(j) / kCellsPerWeaver);
    });
  }
}

/// The narrow level strip that joins both faces at the top or the bottom.
void add_edge(TriangleMesh& mesh, const Face& outer, const Face& inner, int weaver, double up) {
  const int columns = outer.stakes * kCellsPerStake;
  const bool top = up > 0.5;
  add_grid(mesh, {columns, 1, true, false}, [&](int i, int j) {
    const double stake = static_cast<double>(i) / kCellsPerStake;
    const Face& face = (j == 0) == top ? outer : inner;
    return Vertex{face.at(weaver, stake, up), dvec3(0.0, top ? 1.0 : -1.0, 0.0), kCane * 0.5f};
  });
}

}  // namespace

double weave_relief() {
  return kRound + kSway;
}

void add_woven_wall(TriangleMesh& mesh, const Outline& middle, double bottom, double top,
                    double half_thickness) {
  const int weavers = std::max(1, static_cast<int>(std::lround((top - bottom) / kWeaverHeight)));
  const int stakes = 2 * static_cast<int>(std::lround(middle.length() / (2.0 * kStakePitch)));
  const double height = (top - bottom) / weavers;
  const Face outer{middle, bottom, height, half_thickness, 1.0, stakes};
  const Face inner{middle, bottom, height, half_thickness, -1.0, stakes};
  add_face(mesh, outer, weavers);
  add_face(mesh, inner, weavers);
  add_edge(mesh, outer, inner, weavers - 1, 1.0);
  add_edge(mesh, outer, inner, 0, 0.0);
}

void add_rope_band(TriangleMesh& mesh, const Outline& path, double offset, double height,
                   double radius) {
  const double length = path.length();
  const int turns = static_cast<int>(std::lround(length / (radius * 5.0)));
  const int columns = turns * 6, sides = 8;
  const auto surface = [&](double u, double v) {
    const Outline::Point point = path.at(u * length);
    const double across = 2.0 * kPi * v;
    const double strand = 1.0 + 0.16 * std::cos(2.0 * (across - kPi * turns * u));
    const dvec3 spoke = point.normal * std::cos(across) + dvec3(0.0, std::sin(across), 0.0);
    return point.position + offset * point.normal + dvec3(0.0, height, 0.0) +
           radius * strand * spoke;
  };
  add_grid(mesh, {columns, sides, true, true}, [&](int i, int j) {
    const double u = static_cast<double>(i) / columns, v = static_cast<double>(j) / sides;
    const double strand = 0.5 + 0.5 * std::cos(2.0 * (2.0 * kPi * v - kPi * turns * u));
    const vec3 color = kCane * static_cast<float>(0.45 + 0.55 * strand);
    return Vertex{surface(u, v), surface_normal(surface, u, v, 1e-5), color};
  });
}

}  // namespace aerostat::model
