// Tests where the samples of a pixel lie.

#include <cstdint>
#include <set>

#include <gtest/gtest.h>

#include "pack/pack_scene.hpp"
#include "rules/sample_square.h"
#include "scene/io.hpp"
#include "support/resolved.hpp"

namespace aerostat::pack {
namespace {

AeroFrame frame_of(int spp, std::uint32_t seed) {
  auto scene = scene::defaults(scene::BiomeKind::sand, scene::View::outside);
  scene.image.spp = spp;
  scene.image.seed = seed;
  scene.image.adaptive_threshold = 0.0;
  return pack_frame(test::resolved(scene), {});
}

// A picture of a few samples must not lie beside one of many.
TEST(Samples, HaveTheirMeanInTheCentreOfThePixel) {
  for (const int spp : {1, 2, 3, 4, 7, 16, 64}) {
    for (const std::uint32_t seed : {1u, 2u, 3u, 77u}) {
      const AeroFrame frame = frame_of(spp, seed);
      double x = 0.0, y = 0.0;
      for (std::uint32_t sample = 0; sample < frame.samples; ++sample) {
        float dx = 0.0f, dy = 0.0f;
        rules::sample_offset(&frame, sample, &dx, &dy);
        x += static_cast<double>(dx);
        y += static_cast<double>(dy);
      }
      EXPECT_NEAR(x / spp, 0.0, 1e-6) << spp << " spp, seed " << seed;
      EXPECT_NEAR(y / spp, 0.0, 1e-6) << spp << " spp, seed " << seed;
    }
  }
}

// A seed turns the pattern, and the mean is taken off, so that patterns of four samples differ by
// which of them is the highest.
TEST(Samples, LieElsewhereWithAnotherSeed) {
  std::set<float> places;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const AeroFrame frame = frame_of(4, seed);
    float dx = 0.0f, dy = 0.0f;
    rules::sample_offset(&frame, 0, &dx, &dy);
    places.insert(dy);
  }
  EXPECT_GE(places.size(), 4u);
}

}  // namespace
}  // namespace aerostat::pack
