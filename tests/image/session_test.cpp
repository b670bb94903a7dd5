// Tests the promises of the library: progress, re-use, and pictures that depend only on the scene.
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <thread>

#include "core/error.hpp"
#include "pictures.hpp"
#include "render/scene_cache.hpp"

namespace aerostat::test {
namespace {

using render::Crop;
using render::Progress;
using render::Session;
using render::Stage;

std::vector<Progress> watched_render(Session& session, const scene::Scene& scene) {
  std::vector<Progress> seen;
  session.render(resolved(scene), {}, [&](const Progress& progress) { seen.push_back(progress); });
  return seen;
}

TEST(Progress, NeverGoesBackAndEndsWithDone) {
  Session session(options());
  const auto scene = small_scene("snow", {320, 180, 9, 128});
  const auto seen = watched_render(session, scene);
  ASSERT_GE(seen.size(), 4u);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_GE(seen[i].fraction, 0.0);
    EXPECT_LE(seen[i].fraction, 1.0);
    if (i == 0) continue;
    const Progress &before = seen[i - 1], &now = seen[i];
    EXPECT_GE(now.stage, before.stage) << "report " << i;
    EXPECT_TRUE(now.stage > before.stage || now.fraction >= before.fraction) << "report " << i;
    EXPECT_GE(now.rays, before.rays) << "report " << i;
    EXPECT_GE(now.seconds, before.seconds) << "report " << i;
    EXPECT_GE(now.samples_done, before.samples_done) << "report " << i;
  }
  EXPECT_EQ(seen.front().stage, Stage::world);
  EXPECT_EQ(seen.back().stage, Stage::done);
  EXPECT_EQ(seen.back().fraction, 1.0);
  EXPECT_EQ(seen.back().samples_done, 9);
  EXPECT_EQ(seen.back().rays, session.stats().rays[render::KernelStage::primary] +
                                  session.stats().rays[render::KernelStage::shadow] +
                                  session.stats().rays[render::KernelStage::ambient]);
}

TEST(Progress, ReportsEveryStageOfAFirstRender) {
  Session session(options());
  std::set<Stage> stages;
  for (const Progress& p : watched_render(session, small_scene("sand"))) stages.insert(p.stage);
  for (const Stage stage :
       {Stage::world, Stage::kernels, Stage::upload, Stage::rays, Stage::done}) {
    EXPECT_TRUE(stages.count(stage)) << "stage " << static_cast<int>(stage);
  }
}

TEST(Layers, LeftOutLeaveTheLightAndTheCountsAsTheyAre) {
  const auto scene = small_scene("snow");
  render::Options light_alone = options();
  light_alone.contents = render::Contents::picture;
  light_alone.guides = false;
  Session whole(options()), lean(light_alone);
  const image::Film expected = whole.render(resolved(scene)), film = lean.render(resolved(scene));
  EXPECT_EQ(film.radiance, expected.radiance);
  EXPECT_EQ(lean.snapshot().radiance, expected.radiance);
  EXPECT_TRUE(film.alpha.empty() && film.distance_m.empty() && film.albedo.empty() &&
              film.normal_ws.empty() && film.object_id.empty() && film.samples.empty());
  EXPECT_EQ(lean.stats().rays[render::KernelStage::primary],
            whole.stats().rays[render::KernelStage::primary]);
  EXPECT_EQ(lean.stats().rays[render::KernelStage::shadow],
            whole.stats().rays[render::KernelStage::shadow]);
  const auto samples =
      std::accumulate(expected.samples.begin(), expected.samples.end(), std::uint64_t{0});
  EXPECT_EQ(whole.stats().rays[render::KernelStage::primary], samples);
}

/// One session for the tests of re-use. Each test begins with a render of the same scene.
class Reuse : public testing::Test {
 protected:
  Reuse() : scene_(small_scene("snow")) { before_ = session().render(resolved(scene_)); }

  static Session& session() {
    static auto& one = *new Session(options());
    return one;
  }

  /// Returns the numbers of worlds, trees and programs that the next render of `scene` had to
  /// build.
  std::array<int, 3> built_by(const scene::Scene& scene) {
    after_ = session().render(resolved(scene));
    const render::Stats& stats = session().stats();
    return {stats.worlds_built, stats.trees_built, stats.programs_built};
  }

  /// Returns whether the session's picture is that of a new session.
  testing::AssertionResult as_if_new(const scene::Scene& scene) const {
    Session fresh(options());
    return same_bits(after_, fresh.render(resolved(scene)));
  }

  scene::Scene scene_;
  image::Film before_, after_;
};

constexpr std::array<int, 3> kNothing = {0, 0, 0};

TEST_F(Reuse, TheSameSceneIsBuiltOnceAndLooksTheSame) {
  EXPECT_EQ(built_by(scene_), kNothing);
  EXPECT_TRUE(same_bits(before_, after_));
}

TEST_F(Reuse, AMovedCameraBuildsNothing) {
  *scene_.camera.position += dvec3(0.3, 0.1, -0.5);
  EXPECT_EQ(built_by(scene_), kNothing);
  EXPECT_FALSE(same_bits(before_, after_));
  EXPECT_TRUE(as_if_new(scene_));
}

TEST_F(Reuse, ACameraThatComesNearBuildsAFinerBalloonAlone) {
  scene_.camera.position = glm::mix(*scene_.camera.position, scene_.balloon.position, 0.6);
  EXPECT_EQ(built_by(scene_), (std::array<int, 3>{1, 1, 0}));
  EXPECT_TRUE(as_if_new(scene_));
}

TEST_F(Reuse, AMovedSunBuildsNothing) {
  scene_.sun.direction = glm::normalize(dvec3(-0.6, 0.5, 0.3));
  EXPECT_EQ(built_by(scene_), kNothing);
  EXPECT_FALSE(same_bits(before_, after_));
  EXPECT_TRUE(as_if_new(scene_));
}

TEST_F(Reuse, AnotherSizeOrSampleCountBuildsNothing) {
  scene_.image.width = 61;
  scene_.image.height = 37;
  scene_.image.spp = 3;
  EXPECT_EQ(built_by(scene_), kNothing);
  EXPECT_EQ(after_.width, 61);
  EXPECT_EQ(after_.height, 37);
  EXPECT_TRUE(as_if_new(scene_));
}

TEST_F(Reuse, AMovedBalloonBuildsTheBalloonAlone) {
  scene_.balloon.position += dvec3(4.0, 2.0, 1.0);
  EXPECT_EQ(built_by(scene_), (std::array<int, 3>{1, 1, 0}));
  EXPECT_FALSE(same_bits(before_, after_));
  EXPECT_TRUE(as_if_new(scene_));
}

TEST_F(Reuse, ARemovedBalloonBuildsNothingAndIsGone) {
  scene_.balloon.enabled = false;
  EXPECT_EQ(built_by(scene_), kNothing);
  EXPECT_TRUE(as_if_new(scene_));
  for (const std::uint32_t id : after_.object_id) {
    ASSERT_LE(id, static_cast<std::uint32_t>(scene::ObjectId::water));
  }
}

TEST_F(Reuse, AnotherLandBuildsTheLandAlone) {
  scene_.terrain.seed += 1;
  EXPECT_EQ(built_by(scene_), (std::array<int, 3>{1, 1, 0}));
  EXPECT_FALSE(same_bits(before_, after_));
  EXPECT_TRUE(as_if_new(scene_));
}

TEST_F(Reuse, SurvivesASceneThatCannotBeRendered) {
  scene::Scene broken = scene_;
  broken.lights.resize(1000);  // more than the kernels take
  EXPECT_THROW(session().render(resolved(broken)), Error);
  EXPECT_EQ(built_by(scene_), kNothing);
  EXPECT_TRUE(same_bits(before_, after_));
}

/// Tests the films that `snapshot` returns during a render. Each of them can be told from all
/// others.
TEST(Snapshot, RefinesWhileTheRenderRuns) {
  Session session(options());
  const auto scene = small_scene("snow", {320, 180, 64, 128});
  EXPECT_EQ(session.snapshot().width, 0) << "before the first render";
  // The key is the radiance of one pixel, which changes in every pass.
  std::map<float, image::Film> seen;
  std::jthread watcher([&](const std::stop_token& end) {
    while (!end.stop_requested()) {
      const image::Film film = session.snapshot();
      if (film.width != 0) seen.emplace(film.radiance[320 * 100 + 160].x, film);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  });
  const image::Film last = session.render(resolved(scene));
  watcher.request_stop();
  watcher.join();
  EXPECT_TRUE(same_bits(session.snapshot(), last));
  EXPECT_GE(seen.size(), 2u) << "no picture before the last one was seen";
  for (const auto& [key, film] : seen) {
    ASSERT_EQ(film.width, 320);
    ASSERT_EQ(film.height, 180);
    double difference = 0.0, brighter = 0.0;
    for (std::size_t i = 0; i < film.radiance.size(); ++i) {
      const vec3 d = film.radiance[i] - last.radiance[i];
      difference += static_cast<double>(std::abs(d.x) + std::abs(d.y) + std::abs(d.z)) / 3.0;
      brighter += static_cast<double>(d.x + d.y + d.z) / 3.0;
    }
    const auto pixels = static_cast<double>(film.radiance.size());
    // The film holds whole passes only. An early picture is rougher than the last one (by 0.021 for
    // the first, which has one sample), but never darker or half empty.
    EXPECT_LT(difference / pixels, 0.04);
    EXPECT_LT(std::abs(brighter) / pixels, 0.004);
  }
}

TEST(Crop, IsTheSameRegionOfTheWholeBitForBit) {
  Session& session = shared_session();
  for (const int spp : {1, 4, 5}) {
    const auto scene = small_scene("tropical", {97, 61, spp, 128});
    const image::Film whole = session.render(resolved(scene));
    for (const Crop crop :
         {Crop{13, 7, 61, 44}, Crop{96, 60, 97, 61}, Crop{0, 30, 97, 31}, Crop{50, 0, 51, 61}}) {
      EXPECT_TRUE(same_bits(cut(whole, crop), session.render(resolved(scene), {}, {}, crop)))
          << "crop " << crop.x0 << "," << crop.y0 << "," << crop.x1 << "," << crop.y1 << " at "
          << spp << " spp";
    }
  }
}

TEST(Crop, OutsideThePictureIsAnErrorOfUsage) {
  const auto scene = small_scene("sand-empty");
  for (const Crop crop :
       {Crop{0, 0, 97, 64}, Crop{-1, 0, 5, 5}, Crop{5, 5, 5, 9}, Crop{9, 5, 3, 9}}) {
    try {
      shared_session().render(resolved(scene), {}, {}, crop);
      FAIL() << "accepted " << crop.x0 << "," << crop.y0 << "," << crop.x1 << "," << crop.y1;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
  }
}

TEST(Tiles, DoNotShowInThePicture) {
  const auto scene = small_scene("snow", {97, 61, 5, 128});
  const image::Film expected = shared_session().render(resolved(scene));
  for (const int pixels : {1, 100, 777, 4096, 1 << 20}) {
    render::Options cut = options();
    cut.tile_pixels = pixels;
    Session session(cut);
    EXPECT_TRUE(same_bits(expected, session.render(resolved(scene)))) << pixels << " pixels a tile";
  }
}

/// A session with a cache of its own, and a scene with clouds whose land is cut ever more finely.
struct Side {
  explicit Side(const char* name) : scene(small_scene(name, {96, 64, 1, 64})), mine(options()) {
    scene.sky.cumulus.cover = 0.3;
    mine.cache = std::make_shared<render::SceneCache>();
  }

  void render() {
    Session session(mine);
    for (int step = 0; step < 4; ++step) {
      scene.terrain.cells = 64 + 16 * step;
      film = session.render(resolved(scene));
    }
  }

  scene::Scene scene;
  render::Options mine;
  image::Film film;
};

/// Each relief, air and chart of clouds is made once: neither session puts out what the other
/// keeps.
TEST(Cache, OfTwoSessionsOnTwoScenesAtOnceIsEachOnesOwn) {
  Side snow("snow"), tropical("tropical");
  std::thread beside([&] { tropical.render(); });
  snow.render();
  beside.join();
  for (const Side* side : {&snow, &tropical}) {
    EXPECT_EQ(side->mine.cache->reliefs.fine.count(), 1);
    EXPECT_EQ(side->mine.cache->packing.air.key.count(), 1);
    EXPECT_EQ(side->mine.cache->packing.clouds.count(), 1);
    EXPECT_TRUE(same_bits(side->film, shared_session().render(resolved(side->scene))));
  }
}

TEST(Memory, TooSmallALimitIsSaidAndLeavesTheSessionUsable) {
  render::Options tight = options();
  tight.memory_limit_bytes = 4u << 20;
  Session session(tight);
  try {
    session.render(resolved(small_scene("snow", {96, 64, 1, 512})));
    FAIL() << "a world of half a million triangles fitted into 4 MiB";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::exhausted);
    EXPECT_NE(std::string(error.what()).find("memory-limit"), std::string::npos) << error.what();
  }
  const auto scene = small_scene("sand-empty", {96, 64, 1, 64});
  EXPECT_TRUE(same_bits(session.render(resolved(scene)), shared_session().render(resolved(scene))));
}

TEST(Stats, CountWhatWasTraced) {
  Session session(options());
  auto scene = small_scene("snow", {96, 64, 4, 128});
  scene.image.filter = scene::Filter::box;
  scene.lights = {{scene.balloon.position, vec3(1.0f), 100.0, true},
                  {scene.balloon.position, vec3(1.0f), 100.0, false}};
  const image::Film film = session.render(resolved(scene));
  const render::Stats& stats = session.stats();
  std::uint64_t hits = 0;
  for (const float alpha : film.alpha)
    hits += static_cast<std::uint64_t>(std::lround(alpha * 4.0f));
  EXPECT_EQ(stats.rays[render::KernelStage::primary], 96u * 64u * 4u);
  EXPECT_EQ(stats.rays[render::KernelStage::shadow], 2 * hits)
      << "the sun and the one lamp that casts shadows";
  EXPECT_EQ(stats.rays[render::KernelStage::ambient], hits);
  EXPECT_GT(stats.device_seconds[render::KernelStage::ambient], 0.0);
  EXPECT_GT(stats.triangles, 2u * 128u * 128u);
  EXPECT_EQ(stats.tree.input_triangles,
            stats.triangles + stats.tree.dropped_degenerate + stats.tree.dropped_non_finite);
  EXPECT_GT(stats.device_bytes, stats.triangles * 36);
  EXPECT_GT(stats.device_seconds[render::KernelStage::primary], 0.0);
  EXPECT_GT(stats.device_seconds[render::KernelStage::shadow], 0.0);
  EXPECT_GT(stats.device_seconds[render::KernelStage::shading], 0.0);
  EXPECT_GE(stats.rays_seconds, 0.0);
  EXPECT_GT(stats.world_seconds, 0.0);
  EXPECT_GT(stats.tree_seconds, 0.0);
}

}  // namespace
}  // namespace aerostat::test
