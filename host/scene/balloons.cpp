#include "scene/balloons.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "scene/palettes.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene {

namespace {

constexpr std::size_t kPalettes = 8;
constexpr std::size_t kPatterns = 5;

/// Returns the place of a balloon, which counts from the ground. Low balloons are more frequent
/// than high ones.
dvec3 any_place(const Festival& festival, Random& random) {
  const double x = festival.center.x + festival.spread_m.x * random.range(-1.0, 1.0);
  const double z = festival.center.y + festival.spread_m.y * random.range(-1.0, 1.0);
  const double up = std::pow(random.unit(), 1.4);
  return {x, std::lerp(festival.lowest_m, festival.highest_m, up), z};
}

/// Returns whether a place is apart from all others. Balloons that take off in a film stand on the
/// ground before, so that their heights do not count.
bool has_room(const Scene& scene, const dvec3& place) {
  const dvec3 counts(1.0, scene.film.launch_s > 0.0 ? 0.0 : 1.0, 1.0);
  const auto others = balloons_of(scene);
  return std::none_of(others.begin(), others.end(), [&](const Balloon* other) {
    return glm::length(counts * (other->position - place)) < scene.festival.apart_m;
  });
}

Balloon any_balloon(const Festival& festival, const dvec3& place, Random& random) {
  Balloon balloon;
  balloon.position = place;
  balloon.diameter_m = random.range(16.5, 21.5);
  balloon.heading_deg = random.range(-180.0, 180.0);
  balloon.gores = 2 * static_cast<int>(random.range(8.0, 15.0));
  balloon.burner = random.chance(2.0 / 3.0) ? festival.burner * random.range(0.5, 1.0) : 0.0;
  balloon.pattern = static_cast<Pattern>(random.bits() % kPatterns);
  dress(balloon, static_cast<Palette>(random.bits() % kPalettes));
  return balloon;
}

}  // namespace

void hold_festival(Scene& scene) {
  constexpr int kTries = 200;
  Random random(scene.festival.seed);
  for (int i = 0; i < scene.festival.count; ++i) {
    for (int attempt = 0; attempt < kTries; ++attempt) {
      const dvec3 place = any_place(scene.festival, random);
      if (!has_room(scene, place)) continue;
      scene.balloons.push_back(any_balloon(scene.festival, place, random));
      break;
    }
  }
  scene.festival.count = 0;
}

std::vector<const Balloon*> balloons_of(const Scene& scene) {
  std::vector<const Balloon*> balloons;
  if (scene.balloon.enabled) balloons.push_back(&scene.balloon);
  for (const Balloon& further : scene.balloons) {
    if (further.enabled) balloons.push_back(&further);
  }
  return balloons;
}

std::vector<Balloon*> all_balloons(Scene& scene) {
  std::vector<Balloon*> balloons{&scene.balloon};
  for (Balloon& further : scene.balloons) balloons.push_back(&further);
  return balloons;
}

}  // namespace aerostat::scene
