#include <algorithm>
#include <cmath>
#include <vector>

#include "plant/foliage.hpp"
#include "plant/random.hpp"
#include "plant/species.hpp"

// This file builds the plants of dry places: stems or blades that fan out from one foot.
namespace aerostat::plant {
namespace {

/// Returns a path that leaves the ground at `foot`, steep or shallow, and bends over outwards.
std::vector<dvec3> bending_path(const dvec3& foot, double around, double length, double lean,
                                double bend, int pieces) {
  const dvec3 out = level_direction(around);
  std::vector<dvec3> path{foot};
  for (int i = 0; i < pieces; ++i) {
    const double angle = lean + bend * (i + 0.5) / pieces;
    const dvec3 step = out * std::sin(angle) + dvec3(0.0, std::cos(angle), 0.0);
    path.push_back(path.back() + step * (length / pieces));
  }
  return path;
}

/// A bush like a tamarisk, with wiry stems and feathery, grey-green twigs. All values are chosen by
/// eye.
struct Scrub {
  double stem_m;
  /// The angle in radians by which the outermost stems lean.
  double lean;
  double bend;
  vec3 green;
};
constexpr Scrub kScrubs[] = {{1.45, 1.05, 0.5, {0.150f, 0.145f, 0.085f}},
                             {2.7, 0.75, 0.9, {0.120f, 0.135f, 0.076f}}};
const vec3 kTwig{0.15f, 0.11f, 0.08f};

struct ScrubLevel {
  int stems, twigs, pieces;
  /// The length and the width of a twig in lengths of the stem.
  double twig_length, twig_width;
  bool round;
};
constexpr ScrubLevel kScrubLevels[3] = {
    {72, 40, 5, 0.17, 0.014, true}, {34, 16, 3, 0.25, 0.045, false}, {15, 4, 2, 0.45, 0.17, false}};

void add_stem(mesh::TriangleMesh& mesh, const Scrub& scrub, const ScrubLevel& level, double t,
              double around, Random& random, const Crown& crown) {
  const double length = scrub.stem_m * random.range(0.7, 1.05);
  const double lean = scrub.lean * std::sqrt(t) * random.range(0.8, 1.15);
  const dvec3 foot = level_direction(around) * (0.06 * scrub.stem_m * t) - dvec3(0.0, 0.05, 0.0);
  const auto path = bending_path(foot, around, length, lean, scrub.bend * t, level.pieces);
  const double radius = 0.006 * scrub.stem_m;
  if (level.round) {
    add_wood(mesh, path, radius, 0.25 * radius, 3, kTwig);
  } else {
    add_blade(mesh, path, across(level_direction(around)).right * (1.5 * radius), kTwig, 1.0,
              crown);
  }
  const vec3 green = random.varied(scrub.green, 0.2, 0.12);
  for (int i = 0; i < level.twigs; ++i) {
    const double s = (0.22 + 0.78 * (i + random.unit()) / level.twigs) * level.pieces;
    const auto piece = std::min(static_cast<std::size_t>(s), path.size() - 2);
    const dvec3 base = glm::mix(path[piece], path[piece + 1], s - static_cast<double>(piece));
    const dvec3 along = glm::normalize(path[piece + 1] - path[piece]);
    const dvec3 direction = glm::normalize(along + 0.9 * random.direction());
    const double size = level.twig_length * length * random.range(0.6, 1.2);
    add_leaf(mesh,
             {base, base + direction * size,
              across(direction).right * (0.5 * level.twig_width * scrub.stem_m), 0.5, 0.4,
              random.varied(green, 0.2, 0.1), 1.2},
             crown);
  }
}

/// Dry grass that stands in a tuft with old blades lying around it. All values are chosen by eye.
struct Tussock {
  double blade_m;
  vec3 straw;
};
constexpr Tussock kTussocks[] = {{0.6, {0.27f, 0.21f, 0.105f}}, {0.9, {0.24f, 0.20f, 0.10f}}};

struct TussockLevel {
  int blades, pieces;
  /// The width of a blade in its lengths.
  double width;
};
constexpr TussockLevel kTussockLevels[3] = {{420, 4, 0.011}, {130, 2, 0.03}, {44, 1, 0.075}};

}  // namespace

void build_scrub(mesh::TriangleMesh& mesh, int variant, Detail detail) {
  const Scrub& scrub = kScrubs[variant];
  const ScrubLevel& level = at_level(kScrubLevels, detail);
  Random random(static_cast<std::uint64_t>(400 + variant));
  const double reach = scrub.stem_m;
  const Crown crown =
      ellipsoid_crown({0.0, 0.3 * reach, 0.0}, dvec3(0.85, 0.75, 0.85) * reach, 0.5);
  for (int k = 0; k < level.stems; ++k) {
    add_stem(mesh, scrub, level, (k + 0.5) / level.stems, 2.399963 * k, random, crown);
  }
}

void build_tussock(mesh::TriangleMesh& mesh, int variant, Detail detail) {
  const Tussock& tussock = kTussocks[variant];
  const TussockLevel& level = at_level(kTussockLevels, detail);
  Random random(static_cast<std::uint64_t>(420 + variant));
  const double size = tussock.blade_m;
  const Crown crown = ellipsoid_crown({0.0, 0.25 * size, 0.0}, dvec3(size), 0.6);
  for (int k = 0; k < level.blades; ++k) {
    const double t = (k + 0.5) / level.blades;
    const double around = 2.399963 * k + random.range(-0.4, 0.4);
    const dvec3 foot = level_direction(random.turn()) * (0.13 * size * std::sqrt(random.unit()));
    const double length = size * random.range(0.6, 1.1) * (1.0 - 0.2 * t);
    const auto path = bending_path(foot - dvec3(0.0, 0.02, 0.0), around, length, 0.95 * t,
                                   random.range(0.3, 1.1) * (0.3 + t), level.pieces);
    const dvec3 wide = across(level_direction(around)).right;
    add_blade(mesh, path, wide * (0.5 * level.width * size),
              random.varied(tussock.straw, 0.25, 0.15), 1.3, crown);
  }
}

}  // namespace aerostat::plant
