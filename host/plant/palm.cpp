#include <algorithm>
#include <cmath>
#include <vector>

#include "model/shapes.hpp"
#include "plant/foliage.hpp"
#include "plant/random.hpp"
#include "plant/species.hpp"

namespace aerostat::plant {
namespace {

/// A coconut palm with a slender trunk that bows to one side, and a head of feathered fronds. All
/// values are chosen by eye.
struct Palm {
  double trunk_m;
  /// The level distance of the head from the foot in metres.
  double bow_m;
  double frond_m;
  vec3 green;
};
constexpr Palm kPalms[] = {{9.6, 2.2, 4.6, {0.068f, 0.112f, 0.026f}},
                           {12.0, 1.0, 4.8, {0.062f, 0.108f, 0.030f}},
                           {6.6, 2.6, 4.2, {0.075f, 0.118f, 0.026f}}};
/// The albedos of the trunk, of dry fronds and of nuts. Chosen by eye.
const vec3 kTrunk{0.20f, 0.17f, 0.135f};
const vec3 kDry{0.20f, 0.135f, 0.06f};
const vec3 kNut{0.11f, 0.105f, 0.03f};

struct Level {
  int fronds;
  /// The number of leaflets on each side of a frond.
  int leaflets;
  /// The width of a leaflet in metres.
  double leaflet_width;
  /// The number of rings of leaf scars on the trunk.
  int rings;
  int trunk_sides;
  int nuts;
};
constexpr Level kLevels[3] = {
    {26, 46, 0.085, 44, 10, 9}, {22, 13, 0.27, 9, 6, 0}, {21, 0, 0.0, 3, 3, 0}};

class PalmBuilder {
 public:
  PalmBuilder(mesh::TriangleMesh& mesh, const Palm& palm, const Level& level, std::uint64_t seed)
      : mesh_(mesh), palm_(palm), level_(level), random_(seed) {
    head_ = trunk_at(1.0);
    const dvec3 center = head_ + dvec3(0.0, 0.1 * palm.frond_m, 0.0);
    crown_ = ellipsoid_crown(center, dvec3(1.05, 0.75, 1.05) * palm.frond_m, 0.45);
  }

  void build() {
    add_trunk();
    for (int k = 0; k < level_.fronds; ++k) add_frond(k);
    for (int k = 0; k < level_.nuts; ++k) {
      const dvec3 out = level_direction(random_.turn()) * random_.range(0.2, 0.32);
      model::add_sphere(mesh_, head_ + out - dvec3(0.0, random_.range(0.1, 0.42), 0.0),
                        random_.range(0.1, 0.135), 7, random_.varied(kNut, 0.25, 0.3));
    }
  }

 private:
  /// Returns a point of the trunk. The trunk is bowed at the foot and upright at the head, as it
  /// grew towards the light.
  dvec3 trunk_at(double s) const {
    const double bow = palm_.bow_m * (1.0 - (1.0 - s) * (1.0 - s));
    return {bow, palm_.trunk_m * s, 0.0};
  }

  void add_trunk() {
    std::vector<dvec3> path{{-0.25, -0.5, 0.0}};
    std::vector<double> radii{0.26};
    for (int i = 0; i <= level_.rings; ++i) {
      const double s = static_cast<double>(i) / level_.rings;
      const double radius = 0.105 + 0.05 * (1.0 - s) + 0.14 * std::exp(-14.0 * s);
      path.push_back(trunk_at(s));
      radii.push_back(radius * 1.07);
      if (level_.rings < 20 || i == level_.rings) continue;
      path.push_back(trunk_at(s + 0.7 / level_.rings));
      radii.push_back(radius * 0.97);
    }
    const auto tone = [this](std::size_t i) {
      const double ring = level_.rings < 20 ? 0.9 : (i % 2 == 1 ? 0.72 : 1.06);
      return kTrunk * static_cast<float>(
                          ring * (0.9 + 0.2 * model::hash_unit(static_cast<std::uint32_t>(i), 5u)));
    };
    model::add_tube(mesh_,
                    {path, level_.trunk_sides, [&](std::size_t i) { return radii[i]; }, tone});
  }

  /// A frond as an arc that rises from the head and bends down under its own weight.
  struct Frond {
    dvec3 head, out, side;
    double length, rise, weight, twist;

    dvec3 at(double s) const {
      const double bent = s - 0.22 * weight * s * s * s;
      return head + length * (out * (bent * std::cos(rise)) +
                              dvec3(0.0, std::sin(rise) * s - weight * s * s, 0.0) +
                              side * (twist * s * s));
    }
    dvec3 along(double s) const { return glm::normalize(at(s + 0.02) - at(s - 0.02)); }
  };

  void add_frond(int k) {
    // Young fronds stand upright in the middle, and old ones hang. The oldest are dry.
    const double age = (k + 0.5) / level_.fronds;
    const double around = 2.399963 * k + random_.range(-0.2, 0.2);
    Frond frond;
    frond.out = level_direction(around);
    frond.side = {-frond.out.z, 0.0, frond.out.x};
    frond.head = head_ + frond.out * 0.1 + dvec3(0.0, 0.25 * (1.0 - age), 0.0);
    frond.length = palm_.frond_m * random_.range(0.85, 1.05) * (0.78 + 0.5 * age * (1.0 - age));
    frond.rise = 1.25 - 1.75 * age + random_.range(-0.12, 0.12);
    frond.weight = 0.22 + 0.42 * age * random_.range(0.8, 1.2);
    frond.twist = random_.range(-0.16, 0.16);
    const bool dry = age > 0.93;
    const vec3 green = dry ? kDry : random_.varied(palm_.green, 0.16, 0.22 * (0.4 + age));
    if (level_.leaflets == 0) {
      add_far_frond(frond, green);
      return;
    }
    const int bones = level_.leaflets > 20 ? 9 : 4;
    std::vector<dvec3> rachis;
    for (int i = 0; i <= bones; ++i) rachis.push_back(frond.at(static_cast<double>(i) / bones));
    add_blade(mesh_, rachis, frond.side * 0.035, green * 1.5f + vec3(0.02f), 0.8, crown_);
    for (int i = 0; i < level_.leaflets; ++i) {
      const double s = 0.1 + 0.9 * (i + 0.5) / level_.leaflets;
      for (const double hand : {-1.0, 1.0}) add_leaflet(frond, s, hand, green);
    }
  }

  /// Adds a leaflet. Leaflets stand out in a V near the head and hang down towards the tip of the
  /// frond.
  void add_leaflet(const Frond& frond, double s, double hand, const vec3& green) {
    const dvec3 along = frond.along(s);
    const dvec3 right = glm::normalize(glm::cross(along, dvec3(0.0, 1.0, 0.0)));
    const dvec3 up = glm::cross(right, along);
    const double shape = std::sqrt(std::max(1.0 - std::pow(2.0 * s - 0.85, 2.0) / 1.45, 0.0));
    const double length = (0.9 * shape + 0.06) * frond.length / 4.6 * random_.range(0.9, 1.1);
    const dvec3 direction = glm::normalize(right * hand + along * (0.45 + 0.6 * s) +
                                           up * (0.3 - 0.5 * s) + 0.1 * random_.direction());
    const dvec3 base = frond.at(s);
    const dvec3 tip =
        base + direction * length - dvec3(0.0, length * random_.range(0.15, 0.5), 0.0);
    const dvec3 wide = glm::normalize(along + 0.25 * up * hand);
    add_leaf(mesh_,
             {base, tip, wide * (0.5 * level_.leaflet_width), 0.3, 0.3,
              random_.varied(green, 0.14, 0.1), 1.12},
             crown_);
  }

  /// Adds a frond as two folded leaves in a row, whose halves slope down from the rachis.
  void add_far_frond(const Frond& frond, const vec3& green) {
    const double width = 0.5 * frond.length / 4.6;
    add_leaf(mesh_, {frond.at(0.04), frond.at(0.66), frond.side * width, 0.55, 0.5, green, 1.0},
             crown_);
    add_leaf(mesh_, {frond.at(0.3), frond.at(1.04), frond.side * width, 0.4, 0.6, green, 1.1},
             crown_);
  }

  mesh::TriangleMesh& mesh_;
  const Palm& palm_;
  const Level& level_;
  Random random_;
  dvec3 head_{0.0};
  Crown crown_;
};

}  // namespace

void build_palm(mesh::TriangleMesh& mesh, int variant, Detail detail) {
  const auto seed = static_cast<std::uint64_t>(200 + variant);
  PalmBuilder(mesh, kPalms[variant], at_level(kLevels, detail), seed).build();
}

}  // namespace aerostat::plant
