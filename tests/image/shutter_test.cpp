// Tests frames for which the shutter is open: they average what the scene is like in the meantime.

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "film/timeline.hpp"
#include "pictures.hpp"
#include "render/moments.hpp"
#include "render/scene_cache.hpp"
#include "scene/source.hpp"
#include "world/resolve.hpp"

namespace aerostat::test {
namespace {

constexpr int kWidth = 160, kHeight = 48;

/// Returns a film of one balloon high up before an even sky, which the wind carries across the
/// picture at 20 m/s.
scene::SceneSource crossing(const std::string& film) {
  return scene::SceneSource::from_text(R"({
    "version": 1, "biome": "sand", "terrain": {"cells": 32}, "vegetation": {"enabled": false},
    "sky": {"radiance": [1, 1, 1]}, "sun": {"shadows": false, "soft_shadows": false},
    "balloon": {"height_above": "sea", "position": [0, 2000, 0]},
    "camera": {"height_above": "sea", "position": [0, 2014, 150], "target": [0, 2014, 0],
               "fov_y_deg": 6},
    "image": {"width": 160, "height": 48, "spp": 64, "exposure_ev": 0,
              "filter": "box"},
    "film": {"fps": 10, "duration_s": 1,
             "wind": [{"speed_m_s": 20, "from_deg": 270}], "turn_deg_s": 0, )" +
                                           film + "}}",
                                       "crossing.json");
}

image::Film frame_of(film::Timeline& timeline, int frame) {
  const auto at = [&](int moment) {
    return world::resolve(timeline.scene_at_time(timeline.time_of_moment(frame, moment)),
                          shared_cache()->reliefs);
  };
  return render::render_moments(shared_session(), at, timeline.moments());
}

/// Returns the number of pixels in a row over which the left edge of what is there goes from
/// nothing to all, as the sum of what is missing from 1 behind the first pixel with anything.
double left_edge(const image::Film& film, int y) {
  double missing = 0.0;
  bool is_begun = false;
  for (int x = 0; x < film.width; ++x) {
    const double alpha = film.alpha[static_cast<std::size_t>(y * film.width + x)];
    is_begun = is_begun || alpha > 0.0;
    if (is_begun && alpha >= 1.0) return missing;
    if (is_begun) missing += 1.0 - alpha;
  }
  return missing;
}

TEST(Shutter, MovingEdgesAreAsWideAsTheirWay) {
  // The nearest part of the envelope's outline is in the plane of its axis, 150 m away.
  const double pixel_m = 150.0 * 2.0 * std::tan(glm::radians(3.0)) / kHeight;
  for (const double angle : {90.0, 180.0, 360.0}) {
    film::Timeline timeline(
        crossing("\"shutter_moments\": 32, \"shutter_angle_deg\": " + std::to_string(angle)),
        shared_cache()->reliefs);
    const image::Film film = frame_of(timeline, 1);
    ASSERT_EQ(film.width, kWidth);
    const double way = 20.0 * 0.1 * angle / 360.0 / pixel_m;
    // An even ramp of that length misses half of it. The first pixel is begun anywhere.
    EXPECT_NEAR(left_edge(film, kHeight / 2), 0.5 * way, 0.6) << angle;
  }
  film::Timeline closed(crossing("\"shutter_moments\": 32"), shared_cache()->reliefs);
  // The width of a pixel alone blurs it by a pixel or so.
  EXPECT_LT(left_edge(frame_of(closed, 1), kHeight / 2), 1.6);
}

TEST(Shutter, AFrameIsTheMeanOfItsMoments) {
  // The sky is alone in the corner, and its radiance goes from 1 to 3 within the frame.
  film::Timeline timeline(
      crossing(
          R"("shutter_angle_deg": 360, "shutter_moments": 16, "keys": [{"value": "/sky/radiance",
                  "ease": "linear", "keys": [{"time_s": 0, "is": [1, 1, 1]},
                                             {"time_s": 0.1, "is": [3, 2, 1]}]}])"),
      shared_cache()->reliefs);
  const image::Film film = frame_of(timeline, 1);
  EXPECT_NEAR(film.radiance[0].x, 2.0f, 1e-4f);
  EXPECT_NEAR(film.radiance[0].y, 1.5f, 1e-4f);
  EXPECT_NEAR(film.radiance[0].z, 1.0f, 1e-4f);
  EXPECT_EQ(film.samples[0], 64u);
}

TEST(Shutter, MomentsThatAreAllTheSameGiveTheBitsOfAPicture) {
  for (const auto& [spp, threshold] : {std::pair{8, 0.0}, {21, 0.0}, {48, 0.02}}) {
    scene::Scene scene = planted_scene("snow", {61, 47, spp, 128});
    scene.image.adaptive_threshold = threshold;
    const scene::ResolvedScene still = resolved(scene);
    const image::Film expected = shared_session().render(still);
    for (const int moments : {2, 5, 8, 32}) {
      const image::Film film = render::render_moments(
          shared_session(), [&](int) { return still; }, moments);
      EXPECT_TRUE(same_bits(expected, film)) << spp << " samples of " << moments << " moments";
    }
  }
}

TEST(Shutter, PixelsInMotionTakeMoreSamples) {
  const std::string adaptive =
      R"("shutter_moments": 8, "keys": [{"value": "/image/adaptive_threshold",
         "keys": [{"time_s": 0, "is": 0.02}]}], "shutter_angle_deg": )";
  const auto samples = [&](const std::string& angle) {
    film::Timeline timeline(crossing(adaptive + angle), shared_cache()->reliefs);
    const image::Film film = frame_of(timeline, 1);
    double sum = 0.0;
    for (const std::uint32_t count : film.samples) sum += count;
    return sum / static_cast<double>(film.samples.size());
  };
  const double closed = samples("0"), open = samples("360");
  EXPECT_GT(open, 1.05 * closed) << open << " and " << closed << " samples";
  EXPECT_LT(open, 60.0) << "the sky at rest takes few";
}

}  // namespace
}  // namespace aerostat::test
