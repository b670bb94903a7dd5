// Tests the path integrator against closed forms and against the local one.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "flat_land.hpp"
#include "lone_objects.hpp"
#include "pack/pack_scene.hpp"
#include "render/test_hooks.hpp"
#include "scene_params.h"

namespace aerostat::test {
namespace {

dvec3 mean_of(const image::Film& film) {
  dvec3 sum(0.0);
  for (const vec3& light : film.radiance) sum += dvec3(light);
  return sum / static_cast<double>(film.radiance.size());
}

scene::Scene path_scene(float albedo, float emission, int bounces) {
  scene::Scene scene = lone_scene();
  scene.light = scene::Integrator::path;
  scene.bounces = bounces;
  scene::Material& material = scene.material(scene::MaterialId::envelope);
  material.albedo = vec3(albedo);
  material.emission = vec3(emission);
  return scene;
}

/// Inside a closed shell that shines everywhere, light of each bounce is as even as that of the
/// first: L = E (1 + a + a^2 + ...).
TEST(Paths, FillAClosedShellWithLight) {
  for (const int bounces : {0, 1, 5}) {
    scene::Scene scene = path_scene(0.5f, 1.0f, bounces);
    scene.camera.position = {0.0, 0.0, 0.5};
    double expected = 0.0;
    for (int i = 0; i <= bounces + 1; ++i) expected += std::pow(0.5, i);
    const image::Film film = lone_film({plain_object(ball(vec3(0.0f), 3.0f))}, scene, 0.0f);
    EXPECT_NEAR(mean_of(film).y, expected, 2e-3 * expected) << bounces << " bounces";
  }
}

/// A square plate at a height, whose normal points up if `up` is 1.
mesh::TriangleMesh plate(float height, float up) {
  constexpr float kHalf = 3000.0f;
  mesh::TriangleMesh mesh;
  for (const float x : {-kHalf, kHalf}) {
    for (const float z : {-kHalf, kHalf}) {
      mesh.positions.emplace_back(x, height, z);
      mesh.normals.emplace_back(0.0f, up, 0.0f);
      mesh.colors.emplace_back(1.0f);
    }
  }
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  return mesh;
}

/// Between two endless plates, of which one shines with E and both reflect a share a, the radiances
/// are L1 = E + a L2 and L2 = a L1, so that L1 = E / (1 - a^2).
TEST(Paths, BounceBetweenTwoPlates) {
  constexpr float kAlbedo = 0.6f, kEmission = 2.0f;
  scene::Scene scene = path_scene(kAlbedo, 0.0f, 40);
  scene::Material& shining = scene.material(scene::MaterialId::basket);
  shining = scene.material(scene::MaterialId::envelope);
  shining.emission = vec3(kEmission);
  scene.camera.position = {0.0, 0.0, 0.0};
  scene.camera.target = {0.0, -1.0, 0.0};
  scene.camera.up = {0.0, 0.0, -1.0};
  scene.image.spp = 64;
  world::Objects plates{plain_object(plate(-1.0f, 1.0f)), plain_object(plate(1.0f, -1.0f))};
  plates[0].material = scene::MaterialId::basket;
  const double below = kEmission / (1.0 - double{kAlbedo} * kAlbedo);
  EXPECT_NEAR(mean_of(lone_film(plates, scene, 0.0f)).y, below, 0.01 * below);
  scene.camera.target = {0.0, 1.0, 0.0};
  const double above = kAlbedo * below;
  EXPECT_NEAR(mean_of(lone_film(plates, scene, 0.0f)).y, above, 0.01 * above);
}

/// Returns the mean radiance of a picture without bounces and thin clouds, as an integrator renders
/// it with `samples` samples a pixel.
dvec3 mean_by(scene::Scene scene, scene::Integrator light, int samples) {
  scene.sky.cloud_cover = 0.0;
  scene.light = light;
  scene.bounces = 0;
  scene.image.spp = samples;
  return mean_of(shared_session().render(resolved(scene)));
}

void expect_same_mean(const scene::Scene& scene, int samples, double relative) {
  const dvec3 local = mean_by(scene, scene::Integrator::local, samples);
  const dvec3 path = mean_by(scene, scene::Integrator::path, samples);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(path[c], local[c], relative * local[c]) << c;
}

TEST(Paths, WithoutBouncesSeeTheSunAsTheLocalModelDoes) {
  auto scene = flat_land();
  scene.sun.irradiance = 3.0;
  scene.sun.direction = glm::normalize(dvec3(0.25, 1.0, -0.15));
  for (const bool soft : {false, true}) {
    scene.sun.soft_shadows = soft;
    expect_same_mean(scene, 16, 1e-3);
  }
}

TEST(Paths, WithoutBouncesSeeTheSunsGlossAsTheLocalModelDoes) {
  auto scene = flat_land();
  scene.sun.irradiance = 3.0;
  scene.sun.direction = glm::normalize(dvec3(0.25, 1.0, -0.15));
  scene.material(scene::MaterialId::terrain).specular = 0.7;
  scene.material(scene::MaterialId::terrain).shininess = 2000.0;
  for (const bool soft : {false, true}) {
    scene.sun.soft_shadows = soft;
    expect_same_mean(scene, 64, 0.01);
  }
}

/// In a lobe that is as narrow as the sun's disc, the material finds the sun as often as a ray to
/// the sun does. The mean of all pixels is that of the local model, whose sun is a point.
TEST(Paths, FindTheSunOnceInANarrowLobe) {
  auto scene = flat_land();
  scene.sun.irradiance = 3.0;
  scene.sun.direction = glm::normalize(dvec3(0.25, 1.0, -0.15));
  scene.sun.soft_shadows = true;
  scene::Material& mirror = scene.material(scene::MaterialId::terrain);
  mirror.ambient = mirror.diffuse = 0.0;
  mirror.specular = 0.7;
  mirror.shininess = 1e5;
  const dvec3 local = mean_by(scene, scene::Integrator::local, 1024);
  scene.light = scene::Integrator::path;
  scene.bounces = 1;
  scene.image.spp = 256;
  scene.sky.cloud_cover = 0.0;
  constexpr std::uint32_t kSeeds = 8;
  double sum = 0.0, squares = 0.0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    scene.image.seed = seed;
    const double mean = mean_of(shared_session().render(resolved(scene))).y;
    sum += mean;
    squares += mean * mean;
  }
  const double path = sum / kSeeds;
  const double noise = std::sqrt((squares / kSeeds - path * path) / (kSeeds - 1));
  std::printf("%.3e +- %.1e by paths, %.3e by the local model\n", path, noise, local.y);
  EXPECT_LT(noise, 0.02 * local.y);
  EXPECT_NEAR(path, local.y, 4.0 * noise + 0.005 * local.y);
}

TEST(Paths, WithoutBouncesSeeLampsAsTheLocalModelDoes) {
  auto scene = flat_land();
  scene.lights = {{{4.0, 6.0, -3.0}, vec3(1.0f), 250.0, true},
                  {{-5.0, 3.0, 2.0}, vec3(1.0f), 90.0, true},
                  {{0.0, 9.0, 8.0}, vec3(1.0f), 400.0, true}};
  expect_same_mean(scene, 256, 0.01);
}

/// The local model takes the sky by nine spherical harmonics, paths take it from its table.
TEST(Paths, WithoutBouncesSeeTheSkyAsTheLocalModelDoes) {
  expect_same_mean(flat_land_under_a_sky(), 64, 0.02);
}

/// The mean radiance of several seeds, and the standard deviation of that mean.
struct Estimate {
  dvec3 mean{0.0}, noise{0.0};
};

Estimate estimate(render::Session& session, scene::Scene scene, std::uint32_t seeds) {
  Estimate result;
  dvec3 squares(0.0);
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    scene.image.seed = seed;
    const dvec3 mean = mean_of(session.render(resolved(scene)));
    result.mean += mean / static_cast<double>(seeds);
    squares += mean * mean / static_cast<double>(seeds);
  }
  result.noise =
      glm::sqrt(glm::max(squares - result.mean * result.mean, dvec3(0.0)) / (seeds - 1.0));
  return result;
}

/// Expects two means within four standard deviations of their difference.
void expect_same(const Estimate& a, const Estimate& b, double most_noise) {
  for (int c = 0; c < 3; ++c) {
    const double noise = std::hypot(a.noise[c], b.noise[c]);
    std::printf("%.5f and %.5f, +- %.5f\n", a.mean[c], b.mean[c], noise);
    EXPECT_LT(noise, most_noise * a.mean[c]) << "too few samples to tell anything";
    EXPECT_NEAR(a.mean[c], b.mean[c], 4.0 * noise) << c;
  }
}

/// Paths with rays to lights agree with paths that go on in all directions alike and find light by
/// chance. The sun is wide here, so that they find it at all. There are no heaped clouds, because
/// their shade on surfaces (cumulus_shadow) is another model than what a ray through them loses,
/// and is that of a narrow sun.
TEST(Paths, AgreeWithAPlainEstimator) {
  for (const char* name : {"sand-basket", "tropical"}) {
    scene::Scene scene = planted_scene(name, {48, 32, 64, 64});
    scene.light = scene::Integrator::path;
    scene.sun.soft_shadows = true;
    scene.sky.cumulus.cover = 0.0;
    std::uint32_t plain = AERO_PATHS_SEEK_THE_SKY;
    render::TestHooks hooks;
    hooks.change_scene = [&plain](pack::PackedScene& packed) {
      packed.numbers.sky.sun_spread = 0.4f;
      packed.numbers.plain_paths = plain;
    };
    render::Session session(options(), hooks);
    const Estimate with_rays = estimate(session, scene, 6);
    plain = AERO_PATHS_PLAIN;
    scene.image.spp = 256;
    expect_same(with_rays, estimate(session, scene, 6), 0.01);
  }
}

/// Pixels that stop early by the spread of their samples have the mean of those that do not.
TEST(Paths, HaveTheSameMeanWithAdaptiveSamples) {
  scene::Scene scene = planted_scene("sand", {64, 48, 64, 64});
  scene.light = scene::Integrator::path;
  const Estimate all = estimate(shared_session(), scene, 6);
  scene.image.adaptive_threshold = 0.02;
  expect_same(all, estimate(shared_session(), scene, 6), 0.002);
}

/// Returns the share of pixels that are brighter than `factor` times the median of the 25 pixels
/// around them.
double share_of_fireflies(const image::Film& film, int width, float factor) {
  const int height = static_cast<int>(film.radiance.size()) / width;
  int count = 0, found = 0;
  for (int y = 2; y < height - 2; ++y) {
    for (int x = 2; x < width - 2; ++x) {
      std::vector<float> around;
      for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
          around.push_back(film.radiance[static_cast<std::size_t>((y + j) * width + x + i)].y);
        }
      }
      const float light = around[12];
      std::nth_element(around.begin(), around.begin() + 12, around.end());
      found += light > factor * around[12] ? 1 : 0;
      ++count;
    }
  }
  return static_cast<double>(found) / count;
}

/// No light is clamped, and still few pixels stand out. The sun's disc and the flame are out of
/// sight in these pictures.
TEST(Paths, HaveFewFireflies) {
  for (const char* name : {"sand", "tropical-basket", "snow-basket"}) {
    scene::Scene scene = planted_scene(name, {160, 96, 16, 128});
    scene.light = scene::Integrator::path;
    scene.image.adaptive_threshold = 0.0;
    const image::Film film = shared_session().render(resolved(scene));
    scene.light = scene::Integrator::local;
    const image::Film local = shared_session().render(resolved(scene));
    const double share = share_of_fireflies(film, 160, 5.0f);
    const double edges = share_of_fireflies(local, 160, 5.0f);
    std::printf("%s: %.5f of pixels, %.5f in local light\n", name, share, edges);
    EXPECT_LT(share, edges + 0.001) << name;
  }
}

TEST(Paths, BringLightThatSurfacesReflect) {
  scene::Scene scene = path_scene(0.8f, 0.0f, 0);
  scene.image.spp = 64;
  const world::Objects balls{plain_object(ball({-1.05f, 0.0f, 0.0f})),
                             plain_object(ball({1.05f, 0.0f, 0.0f}))};
  const dvec3 direct = mean_of(lone_film(balls, scene, 1.0f));
  scene.bounces = 4;
  EXPECT_GT(mean_of(lone_film(balls, scene, 1.0f)).y, 1.002 * direct.y);
}

scene::Scene followed_scene() {
  scene::Scene scene = planted_scene("tropical-basket", {64, 48, 4, 64});
  scene.light = scene::Integrator::path;
  return scene;
}

TEST(Paths, AreTheSameInAnyTile) {
  render::Options tiled = options();
  tiled.tile_pixels = 700;
  EXPECT_TRUE(same_bits(render::Session(tiled).render(resolved(followed_scene())),
                        shared_session().render(resolved(followed_scene()))));
}

TEST(Paths, AreTheSameInACrop) {
  const render::Crop crop{17, 5, 50, 41};
  EXPECT_TRUE(same_bits(shared_session().render(resolved(followed_scene()), {}, {}, crop),
                        cut(shared_session().render(resolved(followed_scene())), crop)));
}

/// Tests that a session goes from one integrator to the other and back.
TEST(Paths, LeaveTheLocalIntegratorAsItWas) {
  scene::Scene local = followed_scene();
  local.light = scene::Integrator::local;
  render::Session session(options());
  const image::Film before = session.render(resolved(local));
  const image::Film followed = session.render(resolved(followed_scene()));
  EXPECT_FALSE(same_bits(followed, before));
  EXPECT_TRUE(same_bits(session.render(resolved(local)), before));
  EXPECT_EQ(session.stats().programs_built, 0) << "both programs are kept";
  EXPECT_TRUE(same_bits(session.render(resolved(followed_scene())), followed));
}

}  // namespace
}  // namespace aerostat::test
