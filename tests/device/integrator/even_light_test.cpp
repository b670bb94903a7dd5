// Tests that surfaces which absorb nothing cannot be seen in a light of 1 from all sides.
#include "shading_scene.hpp"

namespace aerostat::test {
namespace {

/// Returns a scene in which sky and ground send a radiance of 1 from everywhere. No sun shines.
pack::PackedScene even_light() {
  AeroScene scene = bare_scene();
  set3(scene.sky.sun_irradiance, vec3(1.0f));
  set_ambient(scene, vec3(1.0f), vec3(1.0f));
  return with_even_sky(scene, vec3(1.0f));
}

struct Material {
  int kind = AERO_MATERIAL_PLAIN;
  float albedo = 1.0f, softness = 0.0f, roughness = 0.0f, foam = 0.0f;
};

class EvenLight : public LaneTest {
 protected:
  const Probe probe{"shading.cl", GetParam()};

  /// Returns the radiance of a material from views that go from straight above to grazing.
  std::vector<float> radiance_of(const Material& m) const {
    constexpr std::size_t kViews = 48;
    std::vector<vec3> viewers;
    for (std::size_t i = 0; i < kViews; ++i) {
      viewers.push_back(tilted(1.8f * static_cast<float>(i)));
    }
    const std::vector<float> coefficients{
        1.0f,     1.0f,     0.0f,       1.0f,        0.0f,   m.albedo,
        m.albedo, m.albedo, m.softness, m.roughness, m.foam, static_cast<float>(m.kind),
        0.0f,     0.0f,     0.0f};
    const auto radiance = output<float>(3 * kViews);
    const UploadedScene scene(even_light());
    probe.run("probe_phong", kViews, scene.numbers, scene.sky_table, scene.cloud_chart,
              input(coefficients), input(planes(std::vector<vec3>(kViews, vec3(0.0f)))),
              input(planes(std::vector<vec3>(kViews, vec3(0, 1, 0)))), input(planes(viewers)),
              input(std::vector<std::uint32_t>(kViews, 0u)), radiance);
    std::vector<float> green = radiance.read();
    green.erase(green.begin(), green.begin() + kViews);
    green.resize(kViews);
    return green;
  }
};

TEST_P(EvenLight, HidesWhiteSurfaces) {
  for (const float softness : {0.0f, 1.0f}) {
    for (const float light : radiance_of({.softness = softness})) EXPECT_NEAR(light, 1.0f, 1e-5f);
  }
}

// Water sends back what its surface mirrors and, over a white bed, all that it lets through.
TEST_P(EvenLight, HidesWaterOverAWhiteBed) {
  for (const float roughness : {0.0015f, 0.02f, 0.1f}) {
    for (const float light : radiance_of({.kind = AERO_MATERIAL_WATER, .roughness = roughness})) {
      EXPECT_NEAR(light, 1.0f, 1e-5f) << roughness;
    }
  }
}

// Over a black bed only the mirror is left, which sends back all light at a grazing angle and next
// to none straight up.
TEST_P(EvenLight, ShowsTheMirrorOfWaterOverABlackBed) {
  const auto light = radiance_of({.kind = AERO_MATERIAL_WATER, .albedo = 0.0f, .roughness = 1e-6f});
  EXPECT_NEAR(light.front(), 0.0204f, 1e-3f);
  for (std::size_t i = 1; i < light.size(); ++i) EXPECT_GE(light[i], light[i - 1]) << i;
  EXPECT_GT(light.back(), 0.5f);
  EXPECT_LT(light.back(), 1.0f);
}

AEROSTAT_AT_EVERY_WIDTH(EvenLight);

}  // namespace
}  // namespace aerostat::test
