#include "model/burner.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "model/dimensions.hpp"
#include "model/shapes.hpp"

namespace aerostat::model {
namespace {

using mesh::TriangleMesh;

/// The distance of a burner's axis from the middle along x, in metres. Chosen by eye.
constexpr double kPlaceX = 0.15;
/// The other sizes of a burner, of a gas cylinder and of a flame, in metres. Chosen by eye.
constexpr double kMountZ = 0.10;
constexpr double kCanBottom = kFrameHeight + 0.14;
constexpr double kCanTop = kCanBottom + 0.30;
constexpr double kCanRadius = 0.095;
constexpr double kCoilRadius = 0.112;
constexpr double kCoilTube = 0.0085;
constexpr int kCoilTurns = 6;
constexpr double kCylinderRadius = 0.120;
constexpr double kFlameBottom = kCanBottom + 0.08;
constexpr double kFlameHeight = 1.05;
constexpr double kFlameRadius = 0.088;
/// The albedos of brass and of the red lever. Chosen by eye.
const vec3 kBrass{0.45f, 0.29f, 0.09f};
const vec3 kLeverRed{0.42f, 0.02f, 0.015f};

void add_can(TriangleMesh& mesh, const dvec3& axis, double tolerance_m) {
  const double r = kCanRadius, inner = kCanRadius - 0.006;
  const double low = kCanBottom, high = kCanTop;
  const dvec2 profile[] = {{0.0, low},    {r - 0.02, low},     {r, low + 0.03},  {r, high},
                           {inner, high}, {inner, low + 0.05}, {0.0, low + 0.05}};
  // The upper end has the colours of heated steel.
  add_lathe(mesh, axis, profile, sides_within(tolerance_m, r, 6, 40), [](std::size_t i) {
    return i == 3 || i == 4 ? kSteel * vec3(0.50f, 0.42f, 0.40f) : kSteel * (i > 4 ? 0.3f : 0.9f);
  });
}

void add_coil(TriangleMesh& mesh, const dvec3& axis, double tolerance_m) {
  if (tolerance_m >= kCoilTube) return;
  const int per_turn = sides_within(tolerance_m, kCoilRadius, 8, 32);
  const double bottom = kCanBottom + 0.02, height = kCanTop - kCanBottom - 0.03;
  std::vector<dvec3> path{axis + dvec3(0.06, kCanBottom - 0.03, 0.0),
                          axis + dvec3(kCoilRadius, kCanBottom - 0.02, 0.0)};
  for (int i = 0; i <= kCoilTurns * per_turn; ++i) {
    const double turns = static_cast<double>(i) / per_turn;
    const double angle = 2.0 * std::numbers::pi * turns;
    path.push_back(axis + dvec3(kCoilRadius * std::cos(angle), bottom + height * turns / kCoilTurns,
                                kCoilRadius * std::sin(angle)));
  }
  add_tube(mesh, path, kCoilTube, sides_within(tolerance_m, kCoilTube, 4, 10), kSteel * 0.85f);
}

void add_burner(TriangleMesh& mesh, double side, double tolerance_m) {
  const dvec3 axis(side * kPlaceX, 0.0, 0.0);
  add_box(mesh, axis + dvec3(0.0, kFrameHeight + 0.025, 0.0), {0.075, 0.014, kMountZ + 0.03},
          kSteel * 0.6f);
  add_box(mesh, axis + dvec3(0.0, kFrameHeight + 0.085, 0.0), {0.045, 0.056, 0.045}, kBrass);
  add_can(mesh, axis, tolerance_m);
  add_coil(mesh, axis, tolerance_m);
  // The lever of the blast valve hangs within reach of a hand.
  const dvec3 pivot = axis + dvec3(0.0, kFrameHeight + 0.03, 0.0);
  add_rod(mesh, pivot, pivot + dvec3(0.0, -0.13, 0.02), 0.008,
          sides_within(tolerance_m, 0.008, 4, 10), kSteel);
  add_rod(mesh, pivot + dvec3(0.0, -0.11, 0.017), pivot + dvec3(0.0, -0.22, 0.034), 0.014,
          sides_within(tolerance_m, 0.014, 4, 14), kLeverRed);
}

/// Returns the radius and the height of a point of a flame. The flame is a slim drop, and t runs
/// from 0 at its lower end to 1 at its tip.
dvec2 flame_profile(double t, double height) {
  const double width = std::sqrt(t) * std::pow(1.0 - t, 0.9) * 2.05;
  return {kFlameRadius * width, kFlameBottom + height * t};
}

vec3 flame_color(double t) {
  const vec3 blue(0.35f, 0.50f, 1.0f), yellow(1.0f, 0.82f, 0.38f), orange(1.0f, 0.45f, 0.10f);
  const auto s = static_cast<float>(t);
  return t < 0.25 ? glm::mix(blue, yellow, s * 4.0f)
                  : glm::mix(yellow, orange, (s - 0.25f) / 0.75f);
}

}  // namespace

double burner_mount_z() {
  return kMountZ;
}

double flame_height() {
  return kFlameBottom + 0.45 * kFlameHeight;
}

dvec3 burner_port() {
  return {kPlaceX, kFrameHeight + 0.07, 0.03};
}

void add_burners(TriangleMesh& mesh, const Detail& detail) {
  for (const double side : {-1.0, 1.0}) add_burner(mesh, side, detail.basket_m);
}

void add_jacket(TriangleMesh& mesh, const dvec3& foot, const Detail& detail) {
  const double r = kCylinderRadius, top = kCylinderHeight;
  const int sides = sides_within(detail.basket_m, r, 8, 40);
  const dvec2 jacket[] = {{0.0, 0.0},       {r - 0.02, 0.0},          {r, 0.025},
                          {r, top - 0.215}, {r - 0.010, top - 0.190}, {0.0, top - 0.190}};
  add_lathe(mesh, foot, jacket, sides, [](std::size_t) { return kCover; });
  for (const double y : {0.18, 0.48}) {
    const dvec2 strap[] = {{0.0, y}, {r + 0.005, y}, {r + 0.005, y + 0.04}, {0.0, y + 0.04}};
    add_lathe(mesh, foot, strap, sides, [](std::size_t) { return kBlackRubber; });
  }
}

void add_cylinder(TriangleMesh& mesh, const dvec3& foot, const Detail& detail) {
  const double r = kCylinderRadius, top = kCylinderHeight;
  const int sides = sides_within(detail.basket_m, r, 8, 40);
  const dvec2 dome[] = {{0.0, top - 0.20},      {r - 0.012, top - 0.20}, {r - 0.014, top - 0.165},
                        {r - 0.04, top - 0.11}, {0.05, top - 0.085},     {0.0, top - 0.08}};
  add_lathe(mesh, foot, dome, sides, [](std::size_t) { return kSteel; });
  // These are the guard ring, the valve and its hand wheel.
  add_torus(mesh, foot + dvec3(0.0, top - 0.015, 0.0), 0.075, 0.010, sides,
            sides_within(detail.basket_m, 0.010, 4, 10), kSteel);
  for (int leg = 0; leg < 3; ++leg) {
    const double angle = 2.0 * std::numbers::pi * leg / 3.0 + 0.4;
    const dvec3 at = foot + 0.075 * dvec3(std::cos(angle), 0.0, std::sin(angle));
    add_rod(mesh, at + dvec3(0.0, top - 0.12, 0.0), at + dvec3(0.0, top - 0.015, 0.0), 0.008,
            sides_within(detail.basket_m, 0.008, 4, 10), kSteel);
  }
  const int thin = sides_within(detail.basket_m, 0.014, 4, 14);
  add_rod(mesh, foot + dvec3(0.0, top - 0.10, 0.0), foot + dvec3(0.0, top + 0.04, 0.0), 0.017, thin,
          kBrass);
  add_rod(mesh, foot + dvec3(0.0, top - 0.03, 0.0), foot + dvec3(0.055, top - 0.03, 0.0), 0.010,
          thin, kBrass);
}

TriangleMesh build_flame(double burner, const Detail& detail) {
  const double height = kFlameHeight * (0.4 + 0.6 * burner);
  const int rings = 4 * steps_within(detail.basket_m, kFlameRadius, 10);
  const int sides = sides_within(detail.basket_m, kFlameRadius, 6, 28);
  std::vector<dvec2> profile;
  for (int i = 0; i <= rings; ++i) {
    // The rings are closer where the drop is round.
    const double share = static_cast<double>(i) / rings;
    dvec2 point = flame_profile(share * share * (2.0 - share), height);
    if (i == 0 || i == rings) point.x = 0.0;
    profile.push_back(point);
  }
  TriangleMesh mesh;
  for (const double side : {-1.0, 1.0}) {
    add_lathe(mesh, {side * kPlaceX, 0.0, 0.0}, profile, sides, [rings](std::size_t i) {
      const double share = static_cast<double>(i) / rings;
      return flame_color(share * share * (2.0 - share));
    });
  }
  return mesh;
}

}  // namespace aerostat::model
