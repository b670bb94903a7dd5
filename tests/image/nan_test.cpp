// Tests that no pixel of any scene is NaN, negative or infinite.
#include <algorithm>
#include <cmath>

#include "small_films.hpp"
#include "world/world.hpp"

namespace aerostat::test {
namespace {

class CleanFilm : public testing::TestWithParam<const char*> {};

/// Expects finite light that is not negative, and alphas, albedos and normals within their ranges.
/// A pixel of the sky beside an object may have some of the object's alpha, albedo and normal,
/// because filters mix neighbours. With the box filter, which does not, it must have none.
void expect_clean(const image::Film& film, scene::Filter filter = scene::Filter::gaussian) {
  EXPECT_EQ(film.nan_pixels, 0u);
  ASSERT_FALSE(film.radiance.empty());
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    const auto width = static_cast<std::size_t>(film.width);
    SCOPED_TRACE("pixel " + std::to_string(i % width) + ", " + std::to_string(i / width));
    const vec3 radiance = film.radiance[i];
    ASSERT_TRUE(is_finite(radiance));
    ASSERT_GE(std::min({radiance.x, radiance.y, radiance.z}), 0.0f);
    ASSERT_TRUE(film.alpha[i] >= 0.0f && film.alpha[i] <= 1.0f) << film.alpha[i];
    const bool sky = film.object_id[i] == 0;
    ASSERT_LT(film.object_id[i], scene::kObjectCount);
    const bool bare = sky && filter == scene::Filter::box;
    ASSERT_TRUE(bare ? film.alpha[i] == 0.0f : sky || film.alpha[i] > 0.0f);
    ASSERT_EQ(sky, std::isinf(film.distance_m[i]));
    ASSERT_GT(film.distance_m[i], 0.0f);
    ASSERT_LE(glm::length(film.normal_ws[i]), bare ? 0.0f : 1.0f + 1e-4f);
    const vec3 albedo = film.albedo[i];
    ASSERT_GE(std::min({albedo.x, albedo.y, albedo.z}), 0.0f);
    ASSERT_LE(std::max({albedo.x, albedo.y, albedo.z}), bare ? 0.0f : 1.0f + 1e-6f);
  }
}

TEST_P(CleanFilm, HoldsNumbersThatCanBe) {
  expect_clean(small_film(GetParam()));
}

TEST_P(CleanFilm, AtTheFinalQuality) {
  scene::Scene scene = planted_scene(GetParam(), kGoldenSize);
  scene::set_quality(scene, scene::Quality::final);
  expect_clean(shared_session().render(resolved(scene)));
}

TEST_P(CleanFilm, ThroughEveryLens) {
  scene::Scene scene = planted_scene(GetParam(), kGoldenSize);
  scene.camera.aperture_m = 2.0;
  scene.image.filter = scene::Filter::box;
  for (const auto lens :
       {scene::Lens::thin_lens, scene::Lens::panorama, scene::Lens::orthographic}) {
    SCOPED_TRACE("lens " + std::to_string(static_cast<int>(lens)));
    scene.camera.lens = lens;
    expect_clean(shared_session().render(resolved(scene)), scene::Filter::box);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, CleanFilm, testing::ValuesIn(kScenes), scene_test_name);

/// Tests a land without any height, which is a plane.
TEST(CleanFilm, SurvivesALandOfNoHeight) {
  for (const char* name : {"snow", "tropical", "sand"}) {
    const scene::ResolvedScene scene = world::resolve(
        scene::read_file(std::string(AEROSTAT_SOURCE_DIR "/scenes/") + name + ".json",
                         {{"/image/width", "96"},
                          {"/image/height", "64"},
                          {"/terrain/cells", "64"},
                          {"/terrain/height_m", "0"},
                          {"/terrain/dunes/height_m", "0"}}));
    ASSERT_TRUE(std::isfinite(scene.eye().y)) << name;
    const image::Film film = shared_session().render(scene);
    EXPECT_EQ(film.nan_pixels, 0u) << name;
    EXPECT_EQ(shared_session().stats().tree.dropped_non_finite, 0u) << name;
  }
}

/// Tests a camera above the balloon's place that looks straight down, and one below it that looks
/// up.
TEST(CleanFilm, LooksStraightDownAndUpThroughEveryLens) {
  scene::Scene scene = small_scene("sand", {96, 64, 1, 64});
  const dvec3 balloon = scene.balloon.position;
  scene.camera.view_height_m = 200.0;
  scene.camera.fov_y_deg = 100.0;
  for (const double above : {150.0, -20.0}) {
    // The balloon stands north of the point that the camera sees in the middle.
    scene.camera.position = balloon + dvec3(0.0, above, 30.0);
    scene.camera.target = *scene.camera.position - dvec3(0.0, above, 0.0);
    for (const auto lens : {scene::Lens::pinhole, scene::Lens::thin_lens, scene::Lens::panorama,
                            scene::Lens::orthographic}) {
      SCOPED_TRACE(std::to_string(above) + " m, lens " + std::to_string(static_cast<int>(lens)));
      scene.camera.lens = lens;
      const image::Film film = shared_session().render(resolved(scene));
      expect_clean(film);
      if (lens == scene::Lens::panorama) continue;
      int upper = 0, lower = 0;
      for (std::size_t i = 0; i < film.object_id.size(); ++i) {
        if (film.object_id[i] != static_cast<std::uint32_t>(scene::ObjectId::envelope)) continue;
        ++(i < film.object_id.size() / 2 ? upper : lower);
      }
      EXPECT_GT(above > 0.0 ? upper : lower, 2 * (above > 0.0 ? lower : upper));
    }
  }
}

/// Tests lights and cameras at the limits of what a scene may ask for.
TEST(CleanFilm, SurvivesExtremeLight) {
  const auto count_bad = [](const scene::Scene& scene) {
    return shared_session().render(resolved(scene)).nan_pixels;
  };
  auto scene = small_scene("tropical", {96, 64, 4, 128});
  scene.sun.direction = {0.0, 1.0, 0.0};
  EXPECT_EQ(count_bad(scene), 0u) << "sun at the zenith";
  scene.sun.direction = {1.0, 0.0, 0.0};
  EXPECT_EQ(count_bad(scene), 0u) << "sun on the horizon";
  scene.sun.direction = {0.0, -1.0, 0.0};
  EXPECT_EQ(count_bad(scene), 0u) << "sun below the ground";
  scene.lights = {{*scene.camera.position, vec3(1.0f), 1e6, true}};
  EXPECT_EQ(count_bad(scene), 0u) << "a lamp in the eye";
  scene.fog = {true, 10.0, scene.camera.position->y, 1.0, 0.0, 10.0};
  EXPECT_EQ(count_bad(scene), 0u) << "the eye in the fog's sharp top";
  scene.haze.visibility_m = 10.0;
  EXPECT_EQ(count_bad(scene), 0u) << "dense haze";
  scene.haze.scale_height_m = 1.0;
  EXPECT_EQ(count_bad(scene), 0u) << "air that ends below the eye";
  scene.biome.ground.snow_fuzz_m = 0.0;
  scene.biome.ground.rock_slope_deg[0] = scene.biome.ground.rock_slope_deg[1];
  scene.biome.ground.snow_slope_deg[0] = scene.biome.ground.snow_slope_deg[1];
  EXPECT_EQ(count_bad(scene), 0u) << "borders without width";
}

}  // namespace
}  // namespace aerostat::test
