#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/smooth_step.hpp"
#include "plant/foliage.hpp"
#include "plant/random.hpp"
#include "plant/species.hpp"

namespace aerostat::plant {
namespace {

/// The shape of a spruce or larch. It is a cone of branches in loose whorls, which rise at the top
/// and hang further down. All values are chosen by eye.
struct Conifer {
  double height_m;
  /// The radius of the crown at its widest, in metres.
  double radius_m;
  /// The share of the trunk below the crown.
  double bare;
  /// The exponent of the crown's outline. Below 1 the crown is a bulging cone, above 1 a hollow
  /// one.
  double taper;
  /// The distance by which branches hang down, in their lengths.
  double droop;
  /// The variation of the lengths of branches.
  double ragged;
  /// The albedo of the outer needles.
  vec3 green;
};
constexpr Conifer kConifers[] = {
    {17.0, 2.9, 0.05, 0.85, 0.30, 0.16, {0.047f, 0.068f, 0.031f}},
    {14.0, 2.0, 0.05, 0.95, 0.42, 0.14, {0.041f, 0.064f, 0.036f}},
    {21.0, 3.3, 0.16, 0.80, 0.38, 0.32, {0.053f, 0.068f, 0.029f}},
};
constexpr Conifer kLarches[] = {
    {18.0, 2.9, 0.10, 0.95, 0.20, 0.34, {0.082f, 0.118f, 0.036f}},
    {14.0, 2.5, 0.06, 0.90, 0.16, 0.36, {0.090f, 0.128f, 0.038f}},
    {22.0, 3.4, 0.20, 0.90, 0.26, 0.40, {0.078f, 0.112f, 0.036f}},
};
/// The albedo of larch needles in autumn.
const vec3 kGoldenNeedles{0.335f, 0.182f, 0.03f};
/// The albedos of bark and snow. Chosen by eye.
const vec3 kBark{0.100f, 0.084f, 0.070f};
const vec3 kSnow{0.80f, 0.82f, 0.85f};

/// The share of snow in the colour of far needles. Snow covers less area than these needles. Chosen
/// by eye.
constexpr float kBlend = 0.17f;

struct Level {
  int branches;
  /// The number of twigs on each side of a branch.
  int twigs;
  /// The width of a twig in its lengths.
  double twig_width;
  /// The largest width of a twig in metres.
  double widest_twig;
  /// The width of the sheet that stands for a branch's needles, in lengths of the branch.
  double sheet_width;
  /// The reach of the sheet along the branch, in lengths of the branch.
  double sheet_reach;
  int trunk_sides;
};
constexpr Level kLevels[3] = {{275, 12, 0.235, 0.13, 0.42, 0.62, 9},
                              {97, 4, 0.42, 0.5, 0.76, 0.97, 5},
                              {52, 0, 0.0, 0.0, 1.05, 1.06, 3}};

class ConiferBuilder {
 public:
  ConiferBuilder(mesh::TriangleMesh& mesh, const Conifer& tree, bool snowy, const Level& level,
                 std::uint64_t seed)
      : mesh_(mesh), tree_(tree), level_(level), snowy_(snowy), random_(seed) {
    crown_ = [this](const dvec3& p) { return shade(p); };
  }

  void build() {
    const dvec3 trunk[3] = {
        {0.0, -0.5, 0.0}, {0.0, 0.5 * tree_.height_m, 0.0}, {0.0, 0.97 * tree_.height_m, 0.0}};
    add_wood(mesh_, trunk, 0.019 * tree_.height_m, 0.01, level_.trunk_sides, kBark);
    for (int k = 0; k < level_.branches; ++k) add_branch(k);
    add_leader();
  }

 private:
  struct Branch {
    dvec3 origin, out, side;
    double length, rise, sag;

    dvec3 at(double s) const {
      const double y = rise * s - sag * s * s + 0.35 * sag * s * s * s;
      return origin + length * (out * s + dvec3(0.0, y, 0.0));
    }
    dvec3 tangent(double s) const { return glm::normalize(at(s + 0.02) - at(s - 0.02)); }
  };

  /// Returns whether the tree is only a few pixels high. Needles and snow are then blended, because
  /// single samples would hit either the one or the other.
  bool seen_whole() const { return level_.twigs == 0; }

  double crown_foot() const { return tree_.bare * tree_.height_m; }

  /// Returns the radius of the crown at share t of its height.
  double radius(double t) const {
    return tree_.radius_m * std::pow(1.0 - t, tree_.taper) *
           (0.72 + 0.28 * smooth_step(0.0, 0.14, t));
  }

  Shade shade(const dvec3& p) const {
    const double foot = crown_foot();
    const double t = std::clamp((p.y - foot) / (tree_.height_m - foot), 0.0, 0.98);
    const double from_axis = std::hypot(p.x, p.z);
    const double depth = smooth_step(0.1, 0.95, from_axis / (radius(t) + 0.15));
    const double light = (0.30 + 0.70 * depth) * (0.72 + 0.28 * t);
    const dvec3 radial = from_axis > 1e-6 ? dvec3(p.x, 0.0, p.z) / from_axis : dvec3(0.0, 1.0, 0.0);
    return {glm::normalize(radial + dvec3(0.0, 0.5, 0.0)), light};
  }

  void add_branch(int k) {
    // There are more branches towards the top, where they are short. They are gathered in whorls.
    const double u = (k + 0.5) / level_.branches;
    const double loose = u + random_.range(-0.4, 0.4) / level_.branches;
    const double t = 0.985 * (1.0 - std::pow(1.0 - std::clamp(loose, 0.0, 1.0), 1.25));
    const double whorls = tree_.height_m * 1.6;
    const double gathered = t + 0.3 * (std::round(t * whorls) / whorls - t);
    const double around = 2.399963 * k + random_.range(-0.35, 0.35);
    Branch branch;
    branch.out = level_direction(around);
    branch.side = {-branch.out.z, 0.0, branch.out.x};
    branch.origin = {0.0, crown_foot() + gathered * (tree_.height_m - crown_foot()), 0.0};
    branch.length = radius(gathered) * (1.0 + tree_.ragged * random_.range(-1.0, 0.8)) + 0.12;
    branch.rise = -0.18 + 0.85 * t * t + random_.range(-0.1, 0.1);
    branch.sag = tree_.droop * (1.15 - t) * random_.range(0.6, 1.3) * (snowy_ ? 1.3 : 1.0);
    branch.rise -= snowy_ ? 0.1 : 0.0;
    add_needles(branch);
    if (snowy_ && random_.chance(0.5 + 0.4 * std::min(branch.length, 1.0))) add_snow(branch);
  }

  void add_needles(const Branch& branch) {
    vec3 green = random_.varied(tree_.green, 0.22, 0.16);
    if (seen_whole() && snowy_) green = glm::mix(green, kSnow, kBlend);
    add_sheet(branch, level_.twigs > 4 ? green * 0.55f : green);
    if (level_.twigs > 4) add_axis(branch, green);
    const double crowding = level_.twigs > 4 ? 0.35 + 0.55 * branch.length : 1.0;
    const int twigs = static_cast<int>(level_.twigs * crowding);
    for (int j = 0; j < twigs; ++j) {
      const double s = 0.14 + 0.82 * (j + random_.range(0.2, 0.8)) / twigs;
      for (const double hand : {-1.0, 1.0}) add_twig(branch, s, hand, green);
    }
  }

  /// Adds one leaf that stands for the needles under and around a branch. It falls from the trunk
  /// like a tile and keeps the crown closed.
  void add_sheet(const Branch& branch, const vec3& green) {
    const double reach = level_.sheet_reach * random_.range(0.92, 1.06);
    const dvec3 tip = branch.at(reach) - dvec3(0.0, 0.1 * branch.length, 0.0);
    const double width = level_.sheet_width * (branch.length + 0.008 * tree_.height_m);
    add_leaf(mesh_, {sheet_top(branch), tip, branch.side * (0.5 * width), 0.62, 0.25, green, 1.3},
             crown_);
  }

  /// Returns the upper end of a sheet, which is high enough to meet the branches above.
  dvec3 sheet_top(const Branch& branch) const {
    const double gap = level_.twigs > 4 ? 0.0 : 1.6 * tree_.height_m / level_.branches;
    return branch.origin + dvec3(0.0, 0.42 * branch.length + gap, 0.0);
  }

  void add_axis(const Branch& branch, const vec3& green) {
    const dvec3 thick = branch.side * (0.006 + 0.009 * branch.length);
    add_leaf(mesh_, {branch.at(0.0), branch.at(0.95), thick, 0.1, 0.0, kBark, 0.8}, crown_);
    const dvec3 wide = branch.side * (0.05 * branch.length + 0.02);
    add_leaf(mesh_, {branch.at(0.72), branch.at(1.06), wide, 0.35, 0.5, green, 1.5}, crown_);
  }

  void add_twig(const Branch& branch, double s, double hand, const vec3& green) {
    const double hang = random_.chance(0.4) ? random_.range(0.5, 1.2) : random_.range(0.05, 0.4);
    const dvec3 direction =
        glm::normalize(branch.tangent(s) * random_.range(0.5, 0.9) +
                       branch.side * (hand * random_.range(0.6, 0.95)) - dvec3(0.0, hang, 0.0));
    const double length =
        (0.46 * branch.length * (1.0 - 0.70 * s) + 0.12) * random_.range(0.8, 1.25);
    const double width = std::min(level_.twig_width * length, level_.widest_twig);
    const dvec3 base = branch.at(s);
    const dvec3 wide =
        glm::normalize(glm::cross(direction, dvec3(0.0, 1.0, 0.0)) + 0.4 * random_.direction());
    add_leaf(mesh_,
             {base, base + direction * length, wide * (0.5 * width), 0.38, 0.6,
              random_.varied(green, 0.25, 0.08), 1.45},
             crown_);
  }

  /// Adds snow along the top of a branch. On a sheet it is one leaf that covers the outer part.
  void add_snow(const Branch& branch) {
    const double from = random_.range(0.12, 0.3), to = random_.range(0.85, 1.02);
    if (level_.twigs <= 4) {
      const dvec3 tip = branch.at(level_.sheet_reach * to);
      const dvec3 base = glm::mix(sheet_top(branch), tip, 0.8 * from);
      const dvec3 lift = (branch.out + dvec3(0.0, 0.8, 0.0)) * (0.03 + 0.02 * branch.length);
      const double width = 0.33 * level_.sheet_width * branch.length + 0.05;
      add_snow_leaf(base + lift, tip + lift, branch.side * (0.5 * width));
      return;
    }
    constexpr int kPieces = 4;
    for (int i = 0; i < kPieces; ++i) {
      const double s0 = from + (to - from) * i / kPieces;
      const double s1 = from + (to - from) * (i + 1.25) / kPieces;
      const double swell = random_.range(0.75, 1.2) * (1.15 - 0.5 * s0);
      const dvec3 lift(0.0, (0.05 + 0.035 * branch.length) * swell, 0.0);
      const double width = (0.2 * branch.length + 0.13) * swell;
      add_snow_leaf(branch.at(s0) + 0.7 * lift, branch.at(std::min(s1, 1.05)) + 0.6 * lift,
                    branch.side * (0.5 * width));
    }
  }

  void add_snow_leaf(const dvec3& base, const dvec3& tip, const dvec3& wide) {
    const vec3 color = seen_whole() ? glm::mix(kSnow, tree_.green, 2.4f * kBlend) : kSnow;
    add_leaf(mesh_, {base, tip, wide, 0.5, 0.55, color, 1.0},
             [this](const dvec3& p) { return snow_shade(p); });
  }

  /// Returns the shade of snow. It lies on top in the light, so that the crown hardly darkens it.
  Shade snow_shade(const dvec3& p) const {
    const Shade crown = shade(p);
    return {glm::normalize(crown.outward * 0.6 + dvec3(0.0, 0.8, 0.0)), 0.55 + 0.45 * crown.light};
  }

  void add_leader() {
    const dvec3 top(0.0, tree_.height_m, 0.0);
    const dvec3 foot(0.0, 0.93 * tree_.height_m, 0.0);
    for (const double around : {0.3, 0.3 + 0.5 * std::numbers::pi}) {
      add_leaf(mesh_,
               {foot, top, level_direction(around) * (0.008 * tree_.height_m), 0.3, 0.0,
                tree_.green, 1.2},
               crown_);
    }
  }

  mesh::TriangleMesh& mesh_;
  const Conifer& tree_;
  const Level& level_;
  bool snowy_;
  Random random_;
  Crown crown_;
};

}  // namespace

void build_conifer(mesh::TriangleMesh& mesh, int variant, bool snowy, Detail detail) {
  const Conifer& tree = kConifers[variant];
  const auto seed = static_cast<std::uint64_t>(100 + variant + (snowy ? 10 : 0));
  ConiferBuilder(mesh, tree, snowy, at_level(kLevels, detail), seed).build();
}

void build_larch(mesh::TriangleMesh& mesh, int variant, bool golden, Detail detail) {
  Conifer tree = kLarches[variant];
  if (golden) tree.green = kGoldenNeedles * (1.0f - 0.1f * static_cast<float>(variant));
  const auto seed = static_cast<std::uint64_t>(150 + variant);
  ConiferBuilder(mesh, tree, false, at_level(kLevels, detail), seed).build();
}

}  // namespace aerostat::plant
