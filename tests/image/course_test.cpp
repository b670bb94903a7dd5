// Tests renders that pause, end early and go on from their sums, in the same session or another.
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "pictures.hpp"
#include "render/film_sums.hpp"
#include "render/test_hooks.hpp"
#include "support/error_of.hpp"

namespace aerostat::test {
namespace {

using render::Course;
using render::FilmSums;
using render::Pause;
using render::Session;

/// Returns options with which a pass has many launches, so that a pause falls inside of it.
render::Options small_tiles(bool guides = false) {
  render::Options some = options();
  some.tile_pixels = 256;
  some.guides = guides;
  return some;
}

/// Returns a course that pauses whenever it is asked, and ends at the pause `number`. `sums` gets
/// what the render has then.
Course ending_at(int number, std::optional<FilmSums>& sums, int& pauses) {
  Course course;
  pauses = 0;
  course.wants_pause = [](const render::Progress&) { return true; };
  course.at_pause = [number, &sums, &pauses](const Pause& pause) {
    if (++pauses < number) return true;
    sums = pause.sums();
    return false;
  };
  return course;
}

/// Makes launches so slow that a render is asked several times whether it pauses.
render::TestHooks slow_launches() {
  render::TestHooks hooks;
  hooks.before_launch = [](const opencl::Device&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  };
  return hooks;
}

/// Renders in parts of `every` pauses each, in a new session for each second part, and returns the
/// film. `parts` becomes the number of parts.
image::Film rendered_in_parts(const scene::Scene& scene, const render::Options& how, int every,
                              int& parts, std::optional<render::Crop> crop = {}) {
  Session first(how, slow_launches()), second(how, slow_launches());
  std::optional<FilmSums> sums;
  for (parts = 1;; ++parts) {
    std::optional<FilmSums> next;
    int pauses = 0;
    Course course = ending_at(every, next, pauses);
    if (sums) course.from = std::make_shared<const FilmSums>(*sums);
    Session& session = parts % 2 == 0 ? second : first;
    image::Film film = session.render_on(resolved(scene), course, {}, {}, crop);
    if (!next) return film;
    sums = std::move(next);
  }
}

scene::Scene scene_of(int spp, double threshold) {
  scene::Scene scene = planted_scene("snow", {61, 47, spp, 128});
  scene.image.adaptive_threshold = threshold;
  return scene;
}

TEST(Course, PartsGiveTheBitsOfAWholeRender) {
  for (const auto& [spp, threshold] : {std::pair{1, 0.0}, {21, 0.0}, {64, 0.02}}) {
    const scene::Scene scene = scene_of(spp, threshold);
    for (const bool guides : {false, true}) {
      Session whole(small_tiles(guides));
      const image::Film expected = whole.render(resolved(scene));
      for (const int every : {1, 3}) {
        int parts = 0;
        const image::Film film = rendered_in_parts(scene, small_tiles(guides), every, parts);
        EXPECT_TRUE(same_bits(expected, film)) << spp << " spp, parts of " << every << " pauses";
        EXPECT_EQ(expected.metered_ev, film.metered_ev);
        EXPECT_GT(parts, spp > 1 ? 1 : 0);
      }
    }
  }
}

TEST(Course, PartsOfACropAndOfPathsGiveTheSameBits) {
  scene::Scene scene = scene_of(40, 0.02);
  Session whole(small_tiles());
  const render::Crop crop{20, 11, 44, 30};
  int parts = 0;
  const image::Film expected = whole.render(resolved(scene), {}, {}, crop);
  EXPECT_TRUE(same_bits(expected, rendered_in_parts(scene, small_tiles(), 2, parts, crop)));
  scene.light = scene::Integrator::path;
  scene.image.spp = 8;
  const image::Film paths = whole.render(resolved(scene));
  EXPECT_TRUE(same_bits(paths, rendered_in_parts(scene, small_tiles(), 2, parts)));
}

TEST(Course, APauseSaysWhetherThereIsAPictureAndSumsAreThoseOfItsPixels) {
  const scene::Scene scene = scene_of(37, 0.0);
  Session session(small_tiles(), slow_launches());
  Course course;
  int pauses = 0, before_a_picture = 0;
  course.wants_pause = [](const render::Progress&) { return true; };
  course.at_pause = [&](const Pause& pause) {
    const FilmSums sums = pause.sums();
    const auto least =
        std::min_element(sums.pixels.begin(), sums.pixels.end(),
                         [](const auto& a, const auto& b) { return a.samples < b.samples; });
    const auto samples = static_cast<int>(least->samples);
    EXPECT_EQ(pause.is_picture, samples > 0);
    EXPECT_EQ(sums.samples_done, pause.samples_done);
    EXPECT_GE(samples, pause.samples_done);
    EXPECT_GE(pause.fraction, 0.0);
    EXPECT_LE(pause.fraction, 1.0);
    before_a_picture += pause.is_picture ? 0 : 1;
    ++pauses;
    return true;
  };
  const image::Film film = session.render_on(resolved(scene), course);
  EXPECT_TRUE(same_bits(session.render(resolved(scene)), film)) << "pauses change nothing";
  EXPECT_GT(pauses, 3);
  EXPECT_GT(before_a_picture, 0);
}

// A pass of a small picture is over before the host looks at it for the first time.
TEST(Course, ARenderIsAskedAfterEachPassHoweverShortItIs) {
  const scene::Scene scene = small_scene("sand-empty", {16, 8, 37, 32});
  Session session(options());
  session.render(resolved(scene));
  Course course;
  std::vector<int> passes;
  course.wants_pause = [](const render::Progress&) { return true; };
  course.at_pause = [&](const Pause& pause) {
    EXPECT_TRUE(pause.is_picture);
    passes.push_back(pause.samples_done);
    return true;
  };
  session.render_on(resolved(scene), course);
  // The widest packets have 16 lanes: passes of 1, 16, 16 and 4 samples.
  EXPECT_GE(passes.size(), 3u);
}

TEST(Course, AnEarlyEndGivesThePictureSoFar) {
  const scene::Scene scene = scene_of(60, 0.0);
  Session session(small_tiles(), slow_launches());
  std::optional<FilmSums> sums;
  int pauses = 0;
  Course course = ending_at(1, sums, pauses);
  course.wants_pause = [](const render::Progress& now) { return now.samples_done >= 17; };
  const image::Film film = session.render_on(resolved(scene), course);
  ASSERT_TRUE(sums);
  for (std::size_t i = 0; i < film.samples.size(); ++i) {
    ASSERT_EQ(film.samples[i], sums->pixels[i].samples);
    ASSERT_GE(film.samples[i], 17u);
    ASSERT_LT(film.samples[i], 60u);
  }
  EXPECT_TRUE(same_bits(film, session.snapshot()));
}

TEST(Course, SumsOfAnotherPictureAreRefused) {
  const scene::Scene scene = scene_of(21, 0.0);
  Session session(small_tiles(), slow_launches());
  std::optional<FilmSums> sums;
  int pauses = 0;
  session.render_on(resolved(scene), ending_at(2, sums, pauses));
  ASSERT_TRUE(sums);
  const auto kind_with = [&](auto&& change) {
    FilmSums other = *sums;
    change(other);
    Course course;
    course.from = std::make_shared<const FilmSums>(std::move(other));
    return error_of([&] { session.render_on(resolved(scene), course); }).kind();
  };
  EXPECT_EQ(kind_with([](FilmSums& one) { one.window.x1 -= 1; }), ErrorKind::usage);
  EXPECT_EQ(kind_with([](FilmSums& one) { one.samples_done = 21; }), ErrorKind::usage);
  EXPECT_EQ(kind_with([](FilmSums& one) { one.waiting = {{0, 99}}; }), ErrorKind::usage);
  EXPECT_EQ(kind_with([](FilmSums& one) { one.pixels.pop_back(); }), ErrorKind::usage);
  EXPECT_EQ(kind_with([](FilmSums& one) { one.guides.resize(1); }), ErrorKind::usage);
}

}  // namespace
}  // namespace aerostat::test
