// Tests that neighbouring frames of a film agree. Each pixel of a frame is looked for in the next
// frame, by its distance and the cameras of both, and compared there. What differs is noise of the
// samples, detail finer than a pixel, or something that pops.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "film/timeline.hpp"
#include "image/write.hpp"
#include "pictures.hpp"
#include "render/scene_cache.hpp"
#include "scene/source.hpp"
#include "scene/view_axes.hpp"
#include "world/resolve.hpp"

namespace aerostat::test {
namespace {

constexpr int kWidth = 320, kHeight = 180;
/// The side of the squares over which differences are averaged. The noise of single pixels cancels
/// out there, and what pops does not.
constexpr int kTile = 12;
/// A surface is the same if its distance differs by less than this share.
constexpr double kSameDistance = 0.03;
/// The distance at which the sky is compared.
constexpr double kSkyM = 1e9;

/// A film of the snow scene in which the camera flies sideways at 15 m/s, and nothing else moves.
scene::SceneSource pan(const std::string& quality) {
  std::vector<scene::Override> changes{
      {"/quality", quality},
      {"/image/width", std::to_string(kWidth)},
      {"/image/height", std::to_string(kHeight)},
      {"/terrain/cells", "512"},
      {"/balloon/height_above", "sea"},
      {"/balloon/position", "[0, 485, 0]"},
      {"/camera/height_above", "sea"},
      {"/camera/target", "[16, 497, 0]"},
      {"/film/wind", "[]"},
      {"/film/camera", R"({"mode": "path", "look": "target", "path":
                           [{"position": [-10, 481, 86]}, {"position": [95, 488, -19]}]})"}};
  return scene::SceneSource::from_file(AEROSTAT_SOURCE_DIR "/scenes/snow.json").with(changes);
}

/// A developed frame, with what tells where its pixels are.
struct Frame {
  image::Film film;
  image::Pixels pixels;
  dvec3 eye{0.0};
  scene::ViewAxes axes;
  double pixel = 0.0;  // width of a pixel at distance 1
};

Frame render_frame(const scene::Scene& scene) {
  // The exposure is fixed, as that of neighbouring frames nearly is.
  constexpr double kExposure_ev = -1.5;
  const scene::ResolvedScene resolved = world::resolve(scene, shared_cache()->reliefs);
  Frame frame;
  frame.film = shared_session().render(resolved);
  frame.pixels = image::develop(frame.film, kExposure_ev);
  frame.eye = resolved.eye();
  frame.axes = scene::view_axes(resolved->camera);
  frame.pixel = 2.0 * std::tan(glm::radians(resolved->camera.fov_y_deg) / 2.0) / kHeight;
  return frame;
}

/// Returns where the middle of a pixel of one frame lies in another one, in pixels, or nothing if
/// the other frame does not show it or shows something else there.
std::optional<dvec2> place_in(const Frame& other, const Frame& frame, int x, int y) {
  const auto distance_at = [](const Frame& of, int column, int row) {
    const auto at = static_cast<std::size_t>(row * kWidth + column);
    return std::min(static_cast<double>(of.film.distance_m[at]), kSkyM);
  };
  const dvec3 ray = glm::normalize(frame.axes.forward +
                                   (x + 0.5 - 0.5 * kWidth) * frame.pixel * frame.axes.right -
                                   (y + 0.5 - 0.5 * kHeight) * frame.pixel * frame.axes.up);
  const dvec3 seen = frame.eye + distance_at(frame, x, y) * ray - other.eye;
  const double ahead = glm::dot(seen, other.axes.forward);
  if (ahead <= 0.0) return std::nullopt;
  const dvec2 place(glm::dot(seen, other.axes.right) / ahead / other.pixel + 0.5 * kWidth - 0.5,
                    0.5 * kHeight - glm::dot(seen, other.axes.up) / ahead / other.pixel - 0.5);
  if (place.x < 0.0 || place.x >= kWidth - 1 || place.y < 0.0 || place.y >= kHeight - 1) {
    return std::nullopt;
  }
  const double there = distance_at(other, static_cast<int>(std::lround(place.x)),
                                   static_cast<int>(std::lround(place.y)));
  const double here = glm::length(seen);
  if (std::abs(there - here) > kSameDistance * std::min(there, here)) return std::nullopt;
  return place;
}

/// Returns the mean of the three colours between four pixels, 0 to 255.
double grey_at(const image::Pixels& pixels, const dvec2& place) {
  const int x = static_cast<int>(place.x), y = static_cast<int>(place.y);
  const auto grey = [&](int column, int row) {
    const std::uint8_t* const rgb =
        &pixels.rgb[3 * static_cast<std::size_t>(row * pixels.width + column)];
    return (rgb[0] + rgb[1] + rgb[2]) / 3.0;
  };
  const double share = place.x - x;
  const double above = std::lerp(grey(x, y), grey(x + 1, y), share);
  const double below = std::lerp(grey(x, y + 1), grey(x + 1, y + 1), share);
  return std::lerp(above, below, place.y - y);
}

/// How two frames differ, in steps of 8 bits.
struct Flicker {
  double pixels = 0.0;  // mean over the pixels that both frames show
  double sky = 0.0;     // the same over the sky
  double tiles = 0.0;   // that of the squares of kTile pixels which 2 in 100 exceed
  double plants = 0.0;  // change of the number of pixels with plants, as a share of it
};

/// Returns the number of pixels with plants. Where a tree vanishes, the distance changes so much
/// that its pixels are not compared, so that only their number tells.
double plants_in(const image::Film& film) {
  return static_cast<double>(std::count(film.object_id.begin(), film.object_id.end(),
                                        static_cast<std::uint32_t>(scene::ObjectId::plant)));
}

Flicker flicker_of(const Frame& frame, const Frame& next) {
  const int across = kWidth / kTile, down = kHeight / kTile;
  std::vector<double> sums(static_cast<std::size_t>(across * down)), counts(sums.size());
  double all = 0.0, sky = 0.0, all_count = 0.0, sky_count = 0.0;
  for (int y = 0; y < down * kTile; ++y) {
    for (int x = 0; x < across * kTile; ++x) {
      const auto place = place_in(next, frame, x, y);
      if (!place) continue;
      const double off = grey_at(frame.pixels, dvec2(x, y)) - grey_at(next.pixels, *place);
      const auto tile = static_cast<std::size_t>(y / kTile * across + x / kTile);
      sums[tile] += off;
      counts[tile] += 1.0;
      all += std::abs(off);
      all_count += 1.0;
      if (std::isfinite(frame.film.distance_m[static_cast<std::size_t>(y * kWidth + x)])) continue;
      sky += std::abs(off);
      sky_count += 1.0;
    }
  }
  std::vector<double> tiles;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (counts[i] >= kTile * kTile / 2) tiles.push_back(std::abs(sums[i] / counts[i]));
  }
  // Most of the frame must have been compared.
  EXPECT_GT(all_count, 0.7 * kWidth * kHeight);
  EXPECT_GT(sky_count, 0.2 * kWidth * kHeight);
  std::sort(tiles.begin(), tiles.end());
  const double plants = plants_in(frame.film);
  EXPECT_GT(plants, 0.02 * kWidth * kHeight);
  return {all / all_count, sky / sky_count, tiles[tiles.size() * 98 / 100],
          std::abs(plants_in(next.film) - plants) / plants};
}

/// The bounds of the manual (docs/manual/films.md). They are some 1.4 times what was measured.
struct Bounds {
  const char* quality;
  Flicker most;
};

class FlickerTest : public testing::TestWithParam<Bounds> {};

std::string words(const Flicker& flicker) {
  return "pixels " + std::to_string(flicker.pixels) + ", sky " + std::to_string(flicker.sky) +
         ", tiles " + std::to_string(flicker.tiles) + ", plants " + std::to_string(flicker.plants);
}

TEST_P(FlickerTest, NeighbouringFramesAgree) {
  film::Timeline timeline(pan(GetParam().quality), shared_cache()->reliefs);
  const Flicker& most = GetParam().most;
  std::optional<Frame> before;
  for (int number = 101; number <= 103; ++number) {
    Frame frame = render_frame(timeline.scene_at(number));
    if (before) {
      const Flicker flicker = flicker_of(*before, frame);
      EXPECT_LE(flicker.pixels, most.pixels) << words(flicker);
      EXPECT_LE(flicker.sky, most.sky) << words(flicker);
      EXPECT_LE(flicker.tiles, most.tiles) << words(flicker);
      EXPECT_LE(flicker.plants, most.plants) << words(flicker);
      RecordProperty("frame_" + std::to_string(number), words(flicker));
    }
    before = std::move(frame);
  }
}

TEST_P(FlickerTest, WhatPopsIsNoticed) {
  film::Timeline timeline(pan(GetParam().quality), shared_cache()->reliefs);
  const Flicker& most = GetParam().most;
  const Frame frame = render_frame(timeline.scene_at(101));
  // Half of the trees vanish.
  scene::Scene thinned = timeline.scene_at(102);
  thinned.vegetation.density *= 0.5;
  const Flicker half = flicker_of(frame, render_frame(thinned));
  EXPECT_GT(half.plants, 2.0 * most.plants) << words(half);
  // Most of the trees vanish.
  scene::Scene woods = timeline.scene_at(102);
  woods.vegetation.density *= 0.2;
  const Flicker popped = flicker_of(frame, render_frame(woods));
  EXPECT_GT(popped.tiles, most.tiles) << words(popped);
  // Thin and heaped clouds jump by 200 m.
  scene::Scene clouds = timeline.scene_at(102);
  clouds.sky.cloud_drift_m.x += 200.0;
  clouds.sky.cumulus.drift_m.x += 200.0;
  const Flicker jumped = flicker_of(frame, render_frame(clouds));
  EXPECT_GT(jumped.sky, most.sky) << words(jumped);
}

/// Returns the mean difference of the pixels of two pictures in the upper half, in steps of 8 bits.
double sky_difference(const scene::Scene& a, const scene::Scene& b) {
  const image::Pixels one = render_frame(a).pixels, other = render_frame(b).pixels;
  const std::size_t half = one.rgb.size() / 2;
  double sum = 0.0;
  for (std::size_t i = 0; i < half; ++i) sum += std::abs(one.rgb[i] - other.rgb[i]);
  return sum / static_cast<double>(half);
}

TEST(Clouds, ChangeTheirShapeSlowly) {
  // Looks up to heaped clouds, and to thin high cloud.
  for (const char* sky : {R"({"cloud_cover": 0, "cumulus": {"cover": 0.5}})",
                          R"({"cloud_cover": 0.7, "cumulus": {"cover": 0}})"}) {
    film::Timeline timeline(pan("standard")
                                .with({{"/sky", sky},
                                       {"/film/cloud_change_m_s", "20"},
                                       {"/film/camera", "{}"},
                                       {"/camera/position", "[-10, 481, 86]"},
                                       {"/camera/target", "[16, 521, 0]"},
                                       {"/balloon/enabled", "false"}}),
                            shared_cache()->reliefs);
    const scene::Scene scene = timeline.scene_at(11);
    EXPECT_EQ(sky_difference(scene, scene), 0.0);
    const double next = sky_difference(scene, timeline.scene_at(12));
    const double later = sky_difference(scene, timeline.scene_at(241));
    EXPECT_LT(next, 0.7) << sky;
    EXPECT_GT(later, 1.5) << sky;
    EXPECT_GT(later, 5.0 * next) << sky;
  }
}

std::string quality_of(const testing::TestParamInfo<Bounds>& bounds) {
  return bounds.param.quality;
}

INSTANTIATE_TEST_SUITE_P(Qualities, FlickerTest,
                         testing::Values(Bounds{"draft", {6.0, 0.65, 7.5, 0.04}},
                                         Bounds{"standard", {3.5, 0.5, 2.8, 0.04}}),
                         quality_of);

}  // namespace
}  // namespace aerostat::test
