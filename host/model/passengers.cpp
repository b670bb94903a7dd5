#include "model/passengers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "model/shapes.hpp"

namespace aerostat::model {
namespace {

using mesh::TriangleMesh;

/// Faces are left out from this tolerance on, in metres. All sizes and colours are chosen by eye.
constexpr double kFaintestFace = 0.02;

/// A figure: where it stands, where it looks, how tall it is, and its colours.
struct Person {
  dvec2 place{0.0};       // x and z
  double turn_deg = 0.0;  // clockwise from the basket's front
  double height = 1.7;
  bool waves_left = false;
  vec3 skin, hair, jacket, trousers;
};

const std::array<Person, kMostPassengers> kPeople{Person{{0.31, -0.12},
                                                         50.0,
                                                         1.72,
                                                         false,
                                                         {0.55f, 0.33f, 0.22f},
                                                         {0.05f, 0.03f, 0.02f},
                                                         {0.62f, 0.10f, 0.04f},
                                                         {0.04f, 0.06f, 0.12f}},
                                                  Person{{-0.31, -0.10},
                                                         -55.0,
                                                         1.63,
                                                         true,
                                                         {0.30f, 0.16f, 0.09f},
                                                         {0.02f, 0.015f, 0.012f},
                                                         {0.72f, 0.48f, 0.06f},
                                                         {0.09f, 0.07f, 0.05f}},
                                                  Person{{0.02, 0.46},
                                                         170.0,
                                                         1.66,
                                                         false,
                                                         {0.62f, 0.42f, 0.32f},
                                                         {0.30f, 0.17f, 0.06f},
                                                         {0.05f, 0.26f, 0.38f},
                                                         {0.12f, 0.12f, 0.13f}}};

/// A height at which all figures are built, in metres.
constexpr double kBuiltHeight = 1.74;

/// Builds one figure that looks to -z with its feet at the origin.
class Figure {
 public:
  Figure(const Person& person, const Detail& detail) : person_(person), detail_(detail) {}

  TriangleMesh build() {
    add_body();
    add_arm(person_.waves_left ? -1.0 : 1.0, true);
    add_arm(person_.waves_left ? 1.0 : -1.0, false);
    add_head();
    return std::move(mesh_);
  }

 private:
  int sides(double radius) const { return sides_within(detail_.basket_m, radius, 6, 28); }

  /// Appends a round part, stretched along x, y and z about a point.
  void append_stretched(const TriangleMesh& round, const dvec3& middle, const dvec3& by) {
    TriangleMesh part = round;
    for (vec3& position : part.positions) {
      position = vec3(middle + (dvec3(position) - middle) * by);
    }
    for (vec3& normal : part.normals) normal = glm::normalize(vec3(dvec3(normal) / by));
    mesh::append(mesh_, part);
  }

  void add_body() {
    const std::array<dvec2, 11> profile{{{0.0, 0.0},
                                         {0.13, 0.0},
                                         {0.125, 0.45},
                                         {0.150, 0.86},
                                         {0.158, 0.95},
                                         {0.160, 1.02},
                                         {0.176, 1.22},
                                         {0.172, 1.33},
                                         {0.120, 1.425},
                                         {0.055, 1.465},
                                         {0.0, 1.475}}};
    TriangleMesh body;
    add_lathe(body, dvec3(0.0), profile, sides(0.17),
              [this](std::size_t i) { return i < 5 ? person_.trousers : person_.jacket; });
    append_stretched(body, dvec3(0.0), {1.18, 1.0, 0.78});
    add_rod(mesh_, {0.0, 1.43, 0.0}, {0.0, 1.55, -0.005}, 0.05, sides(0.05), person_.skin);
    // A collar in a lighter shade of the jacket.
    add_torus(mesh_, {0.0, 1.455, 0.0}, 0.062, 0.02, sides(0.06), sides(0.02),
              glm::mix(person_.jacket, vec3(0.8f), 0.35f));
  }

  void add_arm(double side, bool waves) {
    const dvec3 shoulder(side * 0.195, 1.375, 0.0);
    const dvec3 elbow = waves ? dvec3(side * 0.34, 1.46, -0.06) : dvec3(side * 0.255, 1.13, -0.04);
    const dvec3 hand = waves ? dvec3(side * 0.36, 1.73, -0.12) : dvec3(side * 0.15, 1.10, -0.24);
    const std::array<dvec3, 7> path{shoulder,
                                    glm::mix(shoulder, elbow, 0.5),
                                    glm::mix(shoulder, elbow, 0.85),
                                    elbow,
                                    glm::mix(elbow, hand, 0.2),
                                    glm::mix(elbow, hand, 0.6),
                                    glm::mix(elbow, hand, 0.92)};
    const auto radius = [](std::size_t i) { return 0.06 - 0.0035 * static_cast<double>(i); };
    add_sphere(mesh_, shoulder, 0.066, sides(0.066), person_.jacket);
    add_tube(mesh_,
             Tube{path, sides(0.06), radius, [this](std::size_t) { return person_.jacket; }});
    TriangleMesh palm;
    add_sphere(palm, hand, 0.046, sides(0.046), person_.skin);
    append_stretched(palm, hand, waves ? dvec3(1.0, 1.35, 0.6) : dvec3(0.8, 0.7, 1.3));
    if (waves && detail_.basket_m < kFaintestFace) {
      for (int finger = -1; finger <= 2; ++finger) {
        const dvec3 root = hand + dvec3(0.019 * (finger - 0.5), 0.04, 0.0);
        add_rod(mesh_, root, root + dvec3(0.008 * (finger - 0.5), 0.07, -0.005), 0.0105,
                sides(0.0105), person_.skin);
      }
      add_rod(mesh_, hand, hand + dvec3(-side * 0.065, 0.04, 0.0), 0.012, sides(0.012),
              person_.skin);
    }
  }

  void add_head() {
    const dvec3 middle(0.0, 1.625, -0.01);
    TriangleMesh head, hair;
    add_sphere(head, middle, 0.098, sides(0.098), person_.skin);
    append_stretched(head, middle, {0.94, 1.2, 1.04});
    const dvec3 crown = middle + dvec3(0.0, 0.028, 0.024);
    add_sphere(hair, crown, 0.104, sides(0.104), person_.hair);
    append_stretched(hair, crown, {1.0, 1.1, 1.0});
    if (detail_.basket_m >= kFaintestFace) return;
    const vec3 dark(0.015f, 0.012f, 0.012f),
        lips = glm::mix(person_.skin, vec3(0.4f, 0.02f, 0.02f), 0.6f);
    for (const double side : {-1.0, 1.0}) {
      add_sphere(mesh_, middle + dvec3(side * 0.034, 0.012, -0.095), 0.0105, sides(0.0105), dark);
      add_sphere(mesh_, middle + dvec3(side * 0.092, 0.0, 0.008), 0.02, sides(0.02), person_.skin);
    }
    add_sphere(mesh_, middle + dvec3(0.0, -0.018, -0.102), 0.016, sides(0.016),
               person_.skin * 0.93f);
    std::array<dvec3, 7> smile;
    for (std::size_t i = 0; i < smile.size(); ++i) {
      const double along = 2.0 * static_cast<double>(i) / (smile.size() - 1) - 1.0;
      smile[i] = middle + dvec3(0.034 * along, -0.062 + 0.014 * along * along,
                                -0.0885 + 0.012 * along * along);
    }
    add_tube(mesh_, smile, 0.0048, 6, lips);
  }

  const Person& person_;
  const Detail& detail_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh build_passengers(int count, const Detail& detail) {
  TriangleMesh all;
  for (int i = 0; i < std::min(count, kMostPassengers); ++i) {
    const Person& person = kPeople[static_cast<std::size_t>(i)];
    TriangleMesh figure = Figure(person, detail).build();
    const double angle = person.turn_deg * std::numbers::pi / 180.0;
    const double size = person.height / kBuiltHeight, c = std::cos(angle), s = std::sin(angle);
    const auto turned = [&](const dvec3& v) {
      return dvec3(c * v.x - s * v.z, v.y, s * v.x + c * v.z);
    };
    for (vec3& position : figure.positions) {
      position = vec3(size * turned(dvec3(position)) + dvec3(person.place.x, 0.0, person.place.y));
    }
    for (vec3& normal : figure.normals) normal = glm::normalize(vec3(turned(dvec3(normal))));
    mesh::append(all, figure);
  }
  return all;
}

}  // namespace aerostat::model
