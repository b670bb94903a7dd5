// Tests seams that are finer than pixels, and the light of the burners, where the answer is known.
#include <algorithm>
#include <cmath>

#include "shading_scene.hpp"

namespace aerostat::test {
namespace {

class Glow : public LaneTest {
 protected:
  const Probe probe{"shading.cl", GetParam()};
};

/// Tests that adjacent pixels share out a line completely, whatever their width.
TEST_P(Glow, PixelsShareALineOut) {
  constexpr std::size_t kPixels = 4096;
  // The probe has the same constant.
  constexpr float kHalf = 0.02f;
  for (const float pixel : {0.001f, 0.02f, 0.07f, 0.5f}) {
    for (const float shift : {0.0f, 0.3f}) {
      std::vector<float> distances(kPixels), pixels(kPixels, pixel);
      for (std::size_t i = 0; i < kPixels; ++i) {
        distances[i] = (static_cast<float>(i) - 2048.0f + shift) * pixel;
      }
      const auto covers = output<float>(kPixels);
      probe.run("probe_line", kPixels, input(distances), input(pixels), covers);
      double sum = 0.0;
      for (const float cover : covers.read()) {
        EXPECT_GE(cover, 0.0f);
        EXPECT_LE(cover, 1.0f);
        sum += static_cast<double>(cover) * static_cast<double>(pixel);
      }
      EXPECT_NEAR(sum, 2.0 * static_cast<double>(kHalf), 1e-4) << pixel;
    }
  }
}

// Tapes run between the gores, which rise from them on both sides, and seams between the panels.
// Seen from afar they cover their share of each pixel.
TEST_P(Glow, TapesLieInTheFoldsBetweenGores) {
  const std::vector<float> u{7.005f, 6.995f, 7.5f, 7.25f, 7.5f},
      v{10.5f, 10.5f, 10.5f, 10.5f, 10.0f};
  const std::size_t count = whole_packets(u.size());
  const auto sewn_at = [&](float pixel) {
    const auto sewn = output<float>(3 * count);
    probe.run("probe_sew", count, input(padded(u)), input(padded(v)), pixel, sewn);
    std::vector<vec3> found;
    const auto values = sewn.read();
    for (std::size_t i = 0; i < u.size(); ++i) found.push_back(from_planes(values, i));
    return found;
  };
  const auto near = sewn_at(0.002f);
  for (std::size_t i = 0; i < u.size(); ++i) {
    EXPECT_EQ(near[i].x, i < 2 ? 1.0f : 0.0f) << "tape at " << u[i];
    EXPECT_EQ(near[i].y, i == 4 ? 1.0f : 0.0f) << "seam at " << v[i];
  }
  EXPECT_LT(near[0].z, -0.2f) << "flat, though the gore rises behind the tape";
  EXPECT_GT(near[1].z, 0.2f) << "and falls before it";
  EXPECT_LT(std::abs(near[3].z), 0.1f);
  EXPECT_NEAR(sewn_at(0.44f)[0].x, 0.1f, 1e-4f) << "a tape of 4.4 cm";
}

TEST_P(Glow, BurnersFollowTheInverseSquareAndTheCosine) {
  AeroScene scene = bare_scene();
  set3(scene.balloons[0].flame, {1.0f, 4.0f, -2.0f});
  set3(scene.balloons[0].flame_light, {3.0f, 2.0f, 1.0f});
  std::vector<vec3> positions, normals;
  std::vector<vec3> expected;
  for (const float distance : {0.3f, 1.0f, 2.0f, 8.0f}) {
    for (int degrees = 0; degrees <= 180; degrees += 15) {
      const float angle = static_cast<float>(degrees) * kPi / 180.0f;
      positions.push_back(vec3(1.0f, 4.0f - distance, -2.0f));
      normals.push_back(vec3(std::sin(angle), std::cos(angle), 0.0f));
      expected.push_back(vec3(3.0f, 2.0f, 1.0f) * std::max(std::cos(angle), 0.0f) /
                         std::max(distance * distance, 0.36f));
    }
  }
  const std::size_t count = whole_packets(positions.size());
  const auto light = output<float>(3 * count);
  probe.run("probe_flame", count, uploaded(scene), input(planes(positions)), input(planes(normals)),
            light);
  const auto values = light.read();
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT(glm::distance(from_planes(values, i), expected[i]),
              2e-5f * glm::length(expected[i]) + 1e-6f)
        << i;
  }
}

/// Tests that cloth which absorbs nothing cannot be seen in an even light of 1 from all sides. From
/// outside and from inside, it is as bright as its surroundings.
TEST_P(Glow, ClothThatAbsorbsNothingVanishesInEvenLight) {
  AeroScene scene = bare_scene();
  set3(scene.sky.sun_irradiance, vec3(1.0f));
  set_ambient(scene, vec3(1.0f), vec3(1.0f));
  constexpr float kThrough = 0.3f;
  // Light that gets in stays until it leaves: transmitted / (1 - reflected) = 1.
  set3(scene.balloons[0].glow_sky, vec3(kThrough / (1.0f - (1.0f - kThrough))));
  std::vector<vec3> normals;
  for (int degrees = 0; degrees <= 180; degrees += 10)
    normals.push_back(tilted(static_cast<float>(degrees)));
  const std::size_t count = whole_packets(normals.size());
  std::vector<std::uint32_t> inside(count, 0u);
  for (std::size_t i = 0; i < count; i += 2) inside[i] = ~0u;
  const auto glow = output<float>(3 * count);
  probe.run("probe_cloth", count, uploaded(scene), input(std::vector<float>{kThrough}),
            input(planes(normals)), input(inside), glow);
  const auto values = glow.read();
  for (std::size_t i = 0; i < normals.size(); ++i) {
    // On the outside, Phong's ambient light adds the light that the front reflects.
    const float front = inside[i] != 0u ? 0.0f : 1.0f - kThrough;
    EXPECT_NEAR(from_planes(values, i).x + front, 1.0f, 1e-5f) << i;
  }
}

AEROSTAT_AT_EVERY_WIDTH(Glow);

}  // namespace
}  // namespace aerostat::test
