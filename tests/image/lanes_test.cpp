// Tests that packets of 1, 4, 8 and 16 rays, built from the same kernel source, give the same
// picture.
//
// All widths run the same operations. Only library functions (exp, pow, sin ...) round differently
// in scalar and vector form, by some units in the last place. With PoCL, differences of at most
// 1e-7 were measured, so 1e-4 of the radiance leaves room for other drivers. If a ray passes an
// edge so closely that the last bit decides, a sample may fall on the other side. A few pixels may
// therefore differ by more.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "pictures.hpp"

namespace aerostat::test {
namespace {

/// The tolerance of the mean linear radiance over all pixels and channels.
constexpr double kMeanTolerance = 1e-6;
/// The tolerance of a pixel's linear radiance, relative above 1.
constexpr double kPixelTolerance = 1e-4;
/// The share of the pixels that may differ by more than the tolerance.
constexpr double kPixelsBeyond = 1e-3;
/// The relative tolerance of a distance.
constexpr double kDistanceTolerance = 1e-4;
/// The share of the pixels whose distances may differ by more.
constexpr double kDistancesBeyond = 1e-3;

struct Difference {
  double mean = 0.0, largest = 0.0;
  /// The shares of pixels that differ by more than the tolerances.
  double pixels_beyond = 0.0, distances_beyond = 0.0;
};

bool same_distance(float a, float b) {
  if (std::isinf(a) || std::isinf(b)) return a == b;
  return std::abs(a - b) <= kDistanceTolerance * std::max(a, b);
}

Difference difference(const image::Film& a, const image::Film& b) {
  Difference result;
  const auto pixels = static_cast<double>(a.radiance.size());
  for (std::size_t i = 0; i < a.radiance.size(); ++i) {
    double worst = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double x = a.radiance[i][c], y = b.radiance[i][c];
      const double off = std::abs(x - y) / std::max(1.0, std::max(x, y));
      result.mean += off / (3.0 * pixels);
      worst = std::max(worst, off);
    }
    result.largest = std::max(result.largest, worst);
    if (!(worst <= kPixelTolerance)) result.pixels_beyond += 1.0 / pixels;
    if (!same_distance(a.distance_m[i], b.distance_m[i])) result.distances_beyond += 1.0 / pixels;
  }
  return result;
}

constexpr std::array kLenses = {scene::Lens::thin_lens, scene::Lens::panorama,
                                scene::Lens::orthographic};

scene::Scene scene_through(scene::Lens lens) {
  scene::Scene scene = planted_scene("sand-empty");
  scene.camera.lens = lens;
  scene.camera.aperture_m = 0.8;
  return scene;
}

std::string title(std::size_t i) {
  return i < kScenes.size() ? kScenes[i] : "lens " + std::to_string(i - kScenes.size());
}

/// Returns the films of all scenes and lenses at one width. The sessions are destroyed as soon as
/// the films are rendered.
const std::vector<image::Film>& films(int lanes) {
  static std::map<int, std::vector<image::Film>> all;
  auto& these = all[lanes];
  if (these.empty()) {
    render::Session session(options(lanes));
    for (const char* name : kScenes) these.push_back(session.render(resolved(planted_scene(name))));
    for (const auto lens : kLenses) these.push_back(session.render(resolved(scene_through(lens))));
  }
  return these;
}

class LaneWidth : public testing::TestWithParam<int> {};

TEST_P(LaneWidth, GivesThePictureOfOneRayAWorkItem) {
  const auto& expected = films(1);
  const auto& actual = films(GetParam());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Difference d = difference(expected[i], actual[i]);
    std::printf("%-16s mean %.2g largest %.2g, beyond: %.3f %% of pixels, %.3f %% of distances\n",
                title(i).c_str(), d.mean, d.largest, 100.0 * d.pixels_beyond,
                100.0 * d.distances_beyond);
    EXPECT_LE(d.mean, kMeanTolerance) << title(i);
    EXPECT_LE(d.pixels_beyond, kPixelsBeyond) << title(i);
    EXPECT_LE(d.distances_beyond, kDistancesBeyond) << title(i);
  }
}

INSTANTIATE_TEST_SUITE_P(All, LaneWidth, testing::Values(4, 8, 16),
                         [](const auto& width) { return "Lanes" + std::to_string(width.param); });

}  // namespace
}  // namespace aerostat::test
