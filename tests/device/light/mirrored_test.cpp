// Tests the word in which a mirror's ray hands on what it has met.

#include <vector>

#include "probe.hpp"

namespace aerostat::test {
namespace {

using Mirrored = LaneTest;

// The word has few bits, but its roundings are random, so that the mean over samples is right.
TEST_P(Mirrored, RadianceKeepsItsMeanOverSamples) {
  const Probe probe{"shading.cl", GetParam()};
  const std::vector<vec3> lights{{0.9f, 0.4f, 0.1f},   {3e-5f, 1e-5f, 2e-5f}, {20.0f, 30.0f, 40.0f},
                                 {0.0f, 0.5f, 0.0f},   {0.2f, 0.2f, 0.2f},    {1e-3f, 0.0f, 0.0f},
                                 {0.05f, 0.3f, 0.02f}, {1.0f, 1.3f, 0.7f}};
  constexpr int kNumbers = 512;
  for (const vec3& light : lights) {
    std::vector<float> numbers;
    for (int i = 0; i < kNumbers; ++i) {
      numbers.push_back((static_cast<float>(i) + 0.5f) / static_cast<float>(kNumbers));
    }
    const auto kept = output<float>(3 * kNumbers);
    probe.run("probe_mirrored", kNumbers, input(planes(std::vector<vec3>(kNumbers, light))),
              input(numbers), kept);
    const auto values = kept.read();
    vec3 mean(0.0f);
    for (std::size_t i = 0; i < kNumbers; ++i) mean += from_planes(values, i);
    mean /= static_cast<float>(kNumbers);
    const float sum = light.x + light.y + light.z;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], light[c], 0.02f * sum) << c;
  }
}

AEROSTAT_AT_EVERY_WIDTH(Mirrored);

}  // namespace
}  // namespace aerostat::test
