// Tests the furnace: an object that reflects all light cannot be seen under a sky that is even on
// all sides.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "flat_land.hpp"
#include "lone_objects.hpp"
#include "scene/materials.hpp"
#include "scene_params.h"

namespace aerostat::test {
namespace {

/// Returns the film of balls in an even sky of radiance 1. `plain_paths` is 0 or one of
/// AERO_PATHS_...
image::Film film_of_balls(const std::vector<vec3>& centres, scene::Integrator light,
                          std::uint32_t plain_paths = 0) {
  scene::Scene scene = lone_scene();
  scene.light = light;
  world::Objects balls;
  for (const vec3& centre : centres) balls.push_back(plain_object(ball(centre)));
  return lone_film(std::move(balls), scene, 1.0f, plain_paths);
}

/// Returns a scene that looks straight down on a white, level land.
scene::Scene white_land() {
  scene::Scene scene = flat_land();
  scene::Ground& ground = scene.biome.ground;
  ground.cover_a = ground.cover_b = ground.rock_a = ground.rock_b = vec3(1.0f);
  ground.snow = ground.beach = vec3(1.0f);
  scene.image.width = kLoneWidth;
  scene.image.height = kLoneHeight;
  scene.image.spp = 16;
  scene.sky.ambient_occlusion = true;
  return scene;
}

/// Expects a radiance of 1 in every pixel. Returns the number of pixels that an object covers.
int expect_nothing_seen(const image::Film& film) {
  int covered = 0;
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    covered += film.alpha[i] == 1.0f ? 1 : 0;
    const vec3 light = film.radiance[i];
    EXPECT_LT(glm::length(light - 1.0f), 2e-6f)
        << "pixel " << i % kLoneWidth << ", " << i / kLoneWidth << ": " << light.x;
    if (testing::Test::HasFailure()) break;
  }
  return covered;
}

TEST(Furnace, AWhiteBallInAnEvenSkyIsNotSeen) {
  EXPECT_GT(expect_nothing_seen(film_of_balls({vec3(0.0f)}, scene::Integrator::local)), 400);
}

/// Directions that are chosen in proportion to the cosine bring exactly the light of an even sky.
TEST(Furnace, AWhiteLandUnderAnEvenSkyIsNotSeen) {
  for (const auto light : {scene::Integrator::local, scene::Integrator::path}) {
    scene::Scene land = white_land();
    land.light = light;
    const image::Film film = lone_film({}, land, 1.0f, AERO_PATHS_WITHOUT_LIGHT_RAYS);
    EXPECT_EQ(expect_nothing_seen(film), kLoneWidth * kLoneHeight);
  }
}

/// Expects that the mean of a film is `expected`, within five standard deviations of the mean by
/// the spread of the pixels, and within `bias`.
void expect_mean(const image::Film& film, double expected, double bias) {
  double sum = 0.0, squares = 0.0;
  for (const vec3& light : film.radiance) {
    sum += static_cast<double>(light.y);
    squares += static_cast<double>(light.y) * static_cast<double>(light.y);
  }
  const auto count = static_cast<double>(film.radiance.size());
  const double mean = sum / count;
  const double noise = std::sqrt(std::max(squares / count - mean * mean, 0.0) / count);
  EXPECT_LT(noise, 2e-3) << "too few samples to tell anything";
  EXPECT_NEAR(mean, expected, 5.0 * noise + bias);
}

TEST(Furnace, RaysToAnEvenSkyBringItsLight) {
  scene::Scene land = white_land();
  land.light = scene::Integrator::path;
  expect_mean(lone_film({}, land, 1.0f, AERO_PATHS_SEEK_THE_SKY), 1.0, 1e-6);
  expect_mean(film_of_balls({{-1.05f, 0.0f, 0.0f}, {1.05f, 0.0f, 0.0f}}, scene::Integrator::path,
                            AERO_PATHS_SEEK_THE_SKY),
              1.0, 1e-4);
}

/// White balls of every material scatter no more light than arrives. Balls of cloth and leaves lose
/// a little with the paths that end inside of them. The ground has colours of its own, and a flame
/// takes no light.
TEST(Furnace, NoMaterialMakesLight) {
  for (std::size_t i = 0; i < scene::kMaterialCount; ++i) {
    const auto id = static_cast<scene::MaterialId>(i);
    if (scene::material_kind(id) == scene::MaterialKind::water) continue;  // has no depth here
    scene::Scene scene = lone_scene();
    scene.light = scene::Integrator::path;
    scene.materials = scene::detail::default_materials(scene.biome.kind);
    scene::Material& material = scene.material(id);
    material.albedo = vec3(1.0f);
    material.emission = vec3(0.0f);
    world::Object object = plain_object(ball(vec3(0.0f)));
    object.material = id;
    world::Objects objects;
    objects.push_back(std::move(object));
    const image::Film film = lone_film(std::move(objects), scene, 1.0f);
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (std::size_t p = 0; p < film.radiance.size(); ++p) {
      if (film.alpha[p] != 1.0f) continue;
      const auto light = static_cast<double>(film.radiance[p].y);
      sum += light;
      squares += light * light;
      count += 1.0;
    }
    const double mean = sum / count;
    const double noise = std::sqrt(std::max(squares / count - mean * mean, 0.0) / count);
    std::printf("%s: %.4f +- %.4f\n", scene::material_name(id).c_str(), mean, noise);
    EXPECT_GT(count, 400.0);
    // Materials without noise are off by the rounding of sums in single precision.
    EXPECT_LT(mean, 1.0 + 4.0 * noise + 1e-6) << scene::material_name(id);
    if (id == scene::MaterialId::terrain || id == scene::MaterialId::flame) continue;
    EXPECT_GT(mean, 0.93) << scene::material_name(id);
  }
}

/// Tests that two balls hide some of the sky from each other, so that the test above can fail.
TEST(Furnace, TwoBallsHideTheSkyFromEachOther) {
  const image::Film film =
      film_of_balls({{-1.05f, 0.0f, 0.0f}, {1.05f, 0.0f, 0.0f}}, scene::Integrator::local);
  float least = 1.0f;
  for (const vec3& light : film.radiance) least = std::min(least, light.y);
  EXPECT_LT(least, 0.8f);
}

/// Light that white balls hide from each other comes back by their reflections. Only paths that
/// end after their last bounce lose light. They are those that are caught between facets or balls.
TEST(Furnace, PathsSeeNoneOfTwoWhiteBalls) {
  for (const std::vector<vec3>& centres :
       {std::vector<vec3>{vec3(0.0f)}, {{-1.05f, 0.0f, 0.0f}, {1.05f, 0.0f, 0.0f}}}) {
    const image::Film film =
        film_of_balls(centres, scene::Integrator::path, AERO_PATHS_WITHOUT_LIGHT_RAYS);
    double sum = 0.0;
    for (const vec3& light : film.radiance) {
      EXPECT_LE(light.y, 1.0f + 2e-6f) << "paths make no light";
      sum += static_cast<double>(light.y);
    }
    EXPECT_NEAR(sum / static_cast<double>(film.radiance.size()), 1.0, 2e-4);
  }
}

}  // namespace
}  // namespace aerostat::test
