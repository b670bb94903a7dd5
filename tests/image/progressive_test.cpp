// Tests progressive renders. Each preview is finer than the one before, and the last is the picture
// itself.
#include "render/progressive.hpp"

#include "core/error.hpp"
#include "pictures.hpp"
#include "world/resolve.hpp"

namespace aerostat::test {
namespace {

using render::Preview;
using render::Step;

/// Returns a scene that is not resolved.
scene::Scene scene_of(const std::string& name, int seed = 1) {
  return scene::read_file(std::string(AEROSTAT_SOURCE_DIR "/scenes/") + name + ".json",
                          {{"/image/width", "150"},
                           {"/image/height", "90"},
                           {"/terrain/cells", "256"},
                           {"/terrain/seed", std::to_string(seed)},
                           {"/vegetation/reach_m", "500"}});
}

struct Seen {
  int width = 0, shrink = 0, samples = 0;
  bool rough = false, draft = false, complete = false;
};

std::vector<Seen> seen_of(render::Progressive& progressive, const scene::Scene& scene,
                          image::Film& last, render::Stats& stats) {
  std::vector<Seen> seen;
  progressive.render(scene, {}, [&](const Preview& preview) {
    seen.push_back({preview.film.width, preview.shrink, preview.samples, preview.rough,
                    preview.draft, preview.complete});
    last = preview.film;
    stats = preview.stats;
    EXPECT_EQ(preview.scene->camera.height_above, scene::HeightReference::sea);
  });
  return seen;
}

TEST(Progressive, StepsHalveUntilThePictureItself) {
  const auto steps = render::steps_to(1280 * 720, 1e6, 0.05, false);
  ASSERT_EQ(steps.size(), 5u);
  EXPECT_EQ(steps[0].shrink, 8) << "14,400 pixels take 14 ms, 57,600 more than 50";
  EXPECT_EQ(steps[2].shrink, 2);
  EXPECT_TRUE(steps[3].shrink == 1 && steps[3].draft);
  EXPECT_TRUE(steps[4].shrink == 1 && !steps[4].draft);
  EXPECT_EQ(render::steps_to(1280 * 720, 1e9, 0.05, true).size(), 1u);
  EXPECT_EQ(render::steps_to(1e9, 1.0, 0.05, true).front().shrink, 16) << "and no further";
}

TEST(Progressive, LooksGetFinerAndTheLastIsThePicture) {
  render::Progressive progressive(options());
  image::Film last;
  render::Stats stats;
  scene::Scene scene = scene_of("snow");
  const auto first = seen_of(progressive, scene, last, stats);
  ASSERT_GE(first.size(), 3u);
  EXPECT_TRUE(first.front().rough) << "before the land is built";
  for (std::size_t i = 1; i < first.size(); ++i) {
    EXPECT_LE(first[i].rough, first[i - 1].rough);
    EXPECT_EQ(first[i].complete, i + 1 == first.size());
    const bool same_land = first[i].rough == first[i - 1].rough;
    EXPECT_TRUE(!same_land || first[i].shrink <= first[i - 1].shrink);
    EXPECT_EQ(first[i].width, (150 + first[i].shrink - 1) / first[i].shrink);
  }
  EXPECT_EQ(first.back().samples, 4);
  EXPECT_TRUE(same_bits(last, shared_session().render(world::resolve(scene))));
}

TEST(Progressive, ALandThatIsThereIsNotBuiltAgain) {
  render::Progressive progressive(options());
  image::Film last;
  render::Stats stats;
  scene::Scene scene = scene_of("sand");
  seen_of(progressive, scene, last, stats);
  scene.sun.direction = {0.0, 0.6, 0.8};
  for (const Seen& preview : seen_of(progressive, scene, last, stats)) EXPECT_FALSE(preview.rough);
  EXPECT_EQ(stats.worlds_built, 0);
  const auto other = seen_of(progressive, scene_of("sand", 2), last, stats);
  EXPECT_TRUE(other.front().rough);
}

// Tests a camera from x = 8192 m on, where meshes count from another origin.
TEST(Progressive, AnotherOriginNeedsNoRoughLook) {
  render::Progressive progressive(options());
  image::Film last;
  render::Stats stats;
  scene::Scene scene = scene_of("sand");
  scene.camera.height_above = scene::HeightReference::sea;
  scene.camera.position = {8100.0, 300.0, 0.0};
  scene.camera.target = {8000.0, 300.0, 0.0};
  seen_of(progressive, scene, last, stats);
  scene.camera.position->x = 8200.0;
  for (const Seen& preview : seen_of(progressive, scene, last, stats)) EXPECT_FALSE(preview.rough);
  const scene::ResolvedScene resolved = world::resolve(scene);
  EXPECT_EQ(resolved.origin(), dvec3(8192.0, 0.0, 0.0));
  EXPECT_TRUE(same_bits(last, shared_session().render(resolved)));
}

/// Returns for each preview whether it was rough. The render is stopped at the first fine preview.
std::vector<bool> rough_until_fine(render::Progressive& progressive, const scene::Scene& scene) {
  std::stop_source stop;
  std::vector<bool> rough;
  const auto watch = [&](const Preview& preview) {
    rough.push_back(preview.rough);
    if (!preview.rough) stop.request_stop();
  };
  try {
    progressive.render(scene, stop.get_token(), watch);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted) << error.what();
  }
  return rough;
}

TEST(Progressive, ALandStaysThoughItsPictureWasGivenUp) {
  render::Progressive progressive(options());
  scene::Scene scene = scene_of("snow", 4);
  scene.image.width = 800;
  scene.image.height = 600;
  EXPECT_TRUE(rough_until_fine(progressive, scene).front());
  scene.sun.irradiance *= 0.5;
  EXPECT_FALSE(rough_until_fine(progressive, scene).front());
}

TEST(Progressive, ACoarseLandDoesNotBuryTheEye) {
  render::Progressive progressive(options());
  scene::Scene scene = scene_of("snow", 5);
  scene.camera.height_above = scene::HeightReference::sea;
  scene.camera.position = {2500.0, -400.0, 1200.0};
  scene.camera.target = {2500.0, -400.0, 1100.0};
  int rough = 0;
  progressive.render(scene, {}, [&](const Preview& preview) {
    const dvec3 eye = preview.scene.eye();
    rough += preview.rough ? 1 : 0;
    if (preview.rough) {
      EXPECT_GE(eye.y, preview.surface->height(eye.x, eye.z) + 1.99);
      EXPECT_LT(std::abs(preview.film.distance_m.back()), 1e9f) << "it sees the ground";
      EXPECT_EQ(preview.scene.target().y, eye.y) << "it looks where it did";
    } else {
      EXPECT_EQ(eye.y, -400.0) << "as the scene says";
    }
  });
  EXPECT_GT(rough, 0);
}

TEST(Progressive, StopsAndGoesOn) {
  render::Progressive progressive(options());
  std::stop_source stop;
  int previews = 0;
  const auto once = [&](const Preview&) {
    ++previews;
    stop.request_stop();
  };
  EXPECT_THROW(progressive.render(scene_of("snow"), stop.get_token(), once), Error);
  EXPECT_EQ(previews, 1);
  image::Film last;
  render::Stats stats;
  EXPECT_TRUE(seen_of(progressive, scene_of("snow"), last, stats).back().complete);
}

}  // namespace
}  // namespace aerostat::test
