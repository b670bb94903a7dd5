// Tests the layers that guide a denoiser: albedo and normal, averaged over the samples.
#include <algorithm>
#include <cmath>

#include "lone_objects.hpp"
#include "pictures.hpp"

namespace aerostat::test {
namespace {

/// Renders a ball of one albedo and gloss before the sky.
image::Film film_of_ball(scene::Integrator light) {
  scene::Scene scene = lone_scene();
  scene.light = light;
  scene.image.filter = scene::Filter::box;
  scene::Material& material = scene.material(scene::MaterialId::envelope);
  material.albedo = {0.5f, 0.25f, 0.125f};
  material.specular = 0.3;
  material.shininess = 5.0;
  material.translucency = 0.5;
  return lone_film({plain_object(ball(vec3(0.0f)))}, scene, 1.0f);
}

TEST(Guides, AreMeansOverTheSamples) {
  // Half of the light shines through, and a lobe of the power 5 reflects 2 / 6 of its strength.
  const vec3 whole = 1.5f * vec3(0.5f, 0.25f, 0.125f) + 0.1f;
  for (const auto light : {scene::Integrator::local, scene::Integrator::path}) {
    const image::Film film = film_of_ball(light);
    int rims = 0;
    for (std::size_t i = 0; i < film.albedo.size(); ++i) {
      const vec3 expected = film.alpha[i] * whole;
      ASSERT_LT(glm::distance(film.albedo[i], expected), 1e-5f) << i << ": " << film.albedo[i].x;
      const float length = glm::length(film.normal_ws[i]);
      ASSERT_LE(length, film.alpha[i] + 1e-5f);
      ASSERT_GE(length, 0.8f * film.alpha[i]);
      rims += film.alpha[i] > 0.0f && film.alpha[i] < 1.0f ? 1 : 0;
    }
    EXPECT_GT(rims, 50) << "pixels at the rim hold sky, which counts as 0";
    const std::size_t middle = film.normal_ws.size() / 2 + kLoneWidth / 2;
    EXPECT_GT(film.normal_ws[middle].z, 0.99f) << "the normal faces the eye";
  }
}

TEST(Guides, AreTheSameByBothIntegrators) {
  const image::Film local = film_of_ball(scene::Integrator::local);
  const image::Film path = film_of_ball(scene::Integrator::path);
  EXPECT_EQ(local.albedo, path.albedo);
  EXPECT_EQ(local.normal_ws, path.normal_ws);
}

TEST(Guides, CountTheSamplesOfPixelsThatConverge) {
  scene::Scene scene = planted_scene("snow", {64, 48, 64, 64});
  scene.image.adaptive_threshold = 0.05;
  const image::Film film = shared_session().render(resolved(scene));
  const auto [least, most] = std::minmax_element(film.samples.begin(), film.samples.end());
  ASSERT_LT(*least, *most) << "some pixels converge";
  for (std::size_t i = 0; i < film.albedo.size(); ++i) {
    if (film.alpha[i] < 1.0f) continue;
    const float length = glm::length(film.normal_ws[i]);
    ASSERT_GT(length, 0.3f) << i << " took " << film.samples[i] << " samples";
    ASSERT_LE(length, 1.0f + 1e-4f);
  }
}

TEST(Guides, AreLeftOutUnlessAskedFor) {
  const scene::Scene scene = small_scene("sand");
  render::Options without = options();
  without.guides = false;
  const image::Film film = render::Session(without).render(resolved(scene));
  EXPECT_TRUE(film.albedo.empty() && film.normal_ws.empty());
  const image::Film whole = shared_session().render(resolved(scene));
  EXPECT_EQ(film.radiance, whole.radiance);
  EXPECT_EQ(film.distance_m, whole.distance_m);
  EXPECT_EQ(film.object_id, whole.object_id);
}

}  // namespace
}  // namespace aerostat::test
