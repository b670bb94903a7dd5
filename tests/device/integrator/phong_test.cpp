// Tests Phong's light model where its answer is known in closed form.
#include <algorithm>
#include <cmath>

#include "shading_scene.hpp"

namespace aerostat::test {
namespace {

/// Points of the same material: positions, normals, directions to the viewer, and the lights that
/// reach them.
struct Points {
  std::vector<vec3> positions, normals, viewers;
  std::vector<std::uint32_t> visible;

  void add(const vec3& normal, const vec3& viewer, std::uint32_t lights,
           const vec3& position = vec3(0.0f)) {
    positions.push_back(position);
    normals.push_back(normal);
    viewers.push_back(viewer);
    visible.push_back(lights);
  }
};

struct Material {
  float ambient = 0.0f, diffuse = 0.0f, specular = 0.0f, shininess = 1.0f, translucency = 0.0f;
  vec3 albedo{1.0f};
  float softness = 0.0f, emission = 0.0f;
  bool burner_light = false;
};

class Phong : public LaneTest {
 protected:
  const Probe probe{"shading.cl", GetParam()};

  std::vector<vec3> shade(const AeroScene& scene, const Material& m, const Points& points) const {
    const std::vector<float> coefficients{m.ambient,
                                          m.diffuse,
                                          m.specular,
                                          m.shininess,
                                          m.translucency,
                                          m.albedo.x,
                                          m.albedo.y,
                                          m.albedo.z,
                                          m.softness,
                                          0.0f,
                                          0.0f,
                                          AERO_MATERIAL_PLAIN,
                                          m.emission,
                                          m.burner_light ? 1.0f : 0.0f,
                                          0.0f};
    const std::size_t count = whole_packets(points.normals.size());
    std::vector<std::uint32_t> visible = points.visible;
    visible.resize(count, 0u);
    const auto radiance = output<float>(3 * count);
    const UploadedScene on_device(with_even_sky(scene));
    probe.run("probe_phong", count, on_device.numbers, on_device.sky_table, on_device.cloud_chart,
              input(coefficients), input(planes(points.positions)), input(planes(points.normals)),
              input(planes(points.viewers)), input(visible), radiance);
    const auto values = radiance.read();
    std::vector<vec3> result;
    for (std::size_t i = 0; i < points.normals.size(); ++i)
      result.push_back(from_planes(values, i));
    return result;
  }
};

void expect_color(const vec3& actual, const vec3& expected, float tolerance, const char* what) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << what << " " << i;
}

TEST_P(Phong, DiffuseFollowsLambertsCosine) {
  AeroScene scene = bare_scene();
  set3(scene.sky.sun_irradiance, vec3(1.0f, 2.0f, 3.0f) * kPi);
  Material material;
  material.diffuse = 0.8f;
  material.albedo = {0.5f, 0.25f, 1.0f};
  Points points;
  for (int degrees = 0; degrees <= 180; degrees += 5) {
    points.add(tilted(static_cast<float>(degrees)), {0, 0, 1}, 1u);
  }
  const auto radiance = shade(scene, material, points);
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const float cosine = std::max(points.normals[i].y, 0.0f);
    expect_color(radiance[i], 0.8f * cosine * vec3(0.5f, 0.5f, 3.0f), 2e-6f, "lit");
  }
}

// Tests that a white rough surface reflects no more than it receives, and most of that. It reflects
// more than Lambert's surface towards the light, and less away from it.
TEST_P(Phong, RoughSurfacesKeepTheEnergyAndLookBackAtTheLight) {
  Material material;
  material.diffuse = 1.0f;
  material.softness = 1.0f;
  constexpr int kRings = 24, kTurns = 48;
  for (const float lean : {0.0f, 30.0f, 60.0f, 80.0f}) {
    // The sun is above, so the surface leans instead.
    Points points;
    const vec3 normal = tilted(lean);
    const vec3 side(0.0f, 0.0f, 1.0f), across = glm::cross(normal, side);
    for (int ring = 0; ring < kRings; ++ring) {
      // The rings have equal weight, because sine^2 is evenly distributed.
      const float sine = std::sqrt((static_cast<float>(ring) + 0.5f) / kRings);
      for (int turn = 0; turn < kTurns; ++turn) {
        const float a = 2.0f * kPi * static_cast<float>(turn) / kTurns;
        points.add(normal,
                   normal * std::sqrt(1.0f - sine * sine) +
                       sine * (side * std::cos(a) + across * std::sin(a)),
                   1u);
      }
    }
    points.add(normal, vec3(0.0f, 1.0f, 0.0f), 1u);
    const auto radiance = shade(bare_scene(), material, points);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < radiance.size(); ++i) sum += radiance[i].x;
    const double reflectance = sum / (kRings * kTurns) / normal.y;
    EXPECT_LE(reflectance, 1.01) << lean;
    EXPECT_GE(reflectance, 0.7) << lean;
    const float sine = std::sqrt(1.0f - normal.y * normal.y);
    // The expected value is A (cos + sin^2) with A = 1 / (3/2 - 2 / (3 pi)).
    expect_color(radiance.back(), vec3((normal.y + sine * sine) / 1.28779f), 2e-5f, "back");
  }
}

TEST_P(Phong, ShadowLeavesExactlyTheAmbientLight) {
  AeroScene scene = bare_scene();
  set_ambient(scene, {0.5f, 1.0f, 2.0f}, {0.25f, 0.25f, 0.25f});
  Material material{0.5f, 1.0f, 1.0f, 20.0f, 0.0f, {1.0f, 0.5f, 0.25f}};
  Points points;
  points.add({0, 1, 0}, {0, 1, 0}, 0u);
  points.add({0, -1, 0}, {0, 1, 0}, 0u);
  points.add({1, 0, 0}, {0, 1, 0}, 0u);
  const auto radiance = shade(scene, material, points);
  expect_color(radiance[0], 0.5f * material.albedo * vec3(0.5f, 1.0f, 2.0f), 1e-6f, "up");
  expect_color(radiance[1], 0.5f * material.albedo * vec3(0.25f), 1e-6f, "down");
  expect_color(radiance[2], 0.5f * material.albedo * vec3(0.375f, 0.625f, 1.125f), 1e-6f, "level");
}

TEST_P(Phong, SpecularPeaksInTheMirrorDirection) {
  const AeroScene scene = bare_scene();
  Material material;
  material.specular = 0.7f;
  material.shininess = 50.0f;
  // The sun is above and the normal leans by 30 degrees, so the mirror image of the sun is at 60.
  Points points;
  for (int degrees = 0; degrees <= 150; ++degrees) {
    points.add(tilted(30.0f), tilted(static_cast<float>(degrees)), 1u);
  }
  const auto radiance = shade(scene, material, points);
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const double off = (static_cast<double>(i) - 60.0) * std::numbers::pi / 180.0;
    const auto expected = static_cast<float>(0.7 * std::pow(std::max(std::cos(off), 0.0), 50.0));
    expect_color(radiance[i], vec3(expected), 2e-5f, "lobe");
  }
  expect_color(radiance[60], vec3(0.7f), 1e-5f, "peak");
}

TEST_P(Phong, NoGlossFromLightBehindTheSurface) {
  Material material;
  material.specular = 1.0f;
  material.shininess = 2.0f;
  Points points;
  points.add(tilted(100.0f), tilted(170.0f), 1u);
  expect_color(shade(bare_scene(), material, points)[0], vec3(0.0f), 0.0f, "behind");
}

TEST_P(Phong, ClothGlowsWithLightFromBehind) {
  Material material;
  material.diffuse = 0.6f;
  material.translucency = 0.3f;
  material.albedo = {1.0f, 0.5f, 0.25f};
  Points points;
  // The sun is behind the cloth with nothing between.
  points.add({0, -1, 0}, {0, -1, 0}, 1u);
  points.add(tilted(120.0f), {0, -1, 0}, 1u);
  // Another layer of the cloth lies between.
  points.add({0, -1, 0}, {0, -1, 0}, 0u);
  // The sun is in front of the cloth.
  points.add({0, 1, 0}, {0, 1, 0}, 1u);
  const auto radiance = shade(bare_scene(), material, points);
  expect_color(radiance[0], 0.3f * material.albedo, 1e-6f, "through");
  expect_color(radiance[1], 0.15f * material.albedo, 1e-6f, "through at 60 degrees");
  expect_color(radiance[2], 0.09f * material.albedo, 1e-6f, "through two layers");
  expect_color(radiance[3], 0.6f * material.albedo, 1e-6f, "in front");
}

// What a surface emits adds to what it reflects, also of the parts that the burners light.
TEST_P(Phong, EmissionAdds) {
  AeroScene scene = bare_scene();
  set3(scene.balloons[0].flame, {0, 2, 0});
  set3(scene.balloons[0].flame_light, {4, 4, 4});
  for (const bool burner_light : {false, true}) {
    Material material;
    material.diffuse = 0.5f;
    material.emission = 3.0f;
    material.burner_light = burner_light;
    Points points;
    points.add({0, 1, 0}, {0, 1, 0}, 1u);
    const auto radiance = shade(scene, material, points);
    expect_color(radiance[0], vec3(3.5f + (burner_light ? 0.5f : 0.0f)), 1e-5f, "emission");
  }
}

AeroScene with_point_lights() {
  AeroScene scene = bare_scene();
  scene.light_count = 2;
  set3(scene.lights[0].position, {0, 4, 0});
  set3(scene.lights[0].intensity, vec3(16.0f * kPi));
  set3(scene.lights[1].position, {0, 0, 3});
  set3(scene.lights[1].intensity, vec3(9.0f * kPi, 0.0f, 0.0f));
  return scene;
}

TEST_P(Phong, PointLightsFallOffWithTheSquareOfTheDistance) {
  Material material;
  material.diffuse = 1.0f;
  Points points;
  for (const float height : {3.0f, 2.0f, 0.0f, -4.0f, -12.0f}) {
    points.add({0, 1, 0}, {0, 1, 0}, 2u, {0, height, 0});
  }
  const auto radiance = shade(with_point_lights(), material, points);
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const float distance = 4.0f - points.positions[i].y;
    const float expected = 16.0f / (distance * distance);
    expect_color(radiance[i], vec3(expected), expected * 2e-6f, "point light");
  }
}

TEST_P(Phong, LightsAddAndEachHasItsOwnShadow) {
  const Material material{1.0f, 0.75f, 0.5f, 8.0f, 0.0f, {0.5f, 0.5f, 0.5f}};
  const vec3 normal = glm::normalize(vec3(0, 1, 1));
  Points points;
  for (std::uint32_t lights = 0; lights < 8; ++lights) points.add(normal, normal, lights);
  AeroScene scene = with_point_lights();
  set_ambient(scene, vec3(0.125f), vec3(0.0f));
  const auto radiance = shade(scene, material, points);
  for (std::uint32_t lights = 0; lights < 8; ++lights) {
    vec3 expected = radiance[0];
    for (const std::uint32_t one : {1u, 2u, 4u}) {
      if ((lights & one) != 0) expected += radiance[one] - radiance[0];
    }
    expect_color(radiance[lights], expected, 2e-6f, "sum");
  }
  EXPECT_GT(radiance[4].x, radiance[0].x);
  EXPECT_EQ(radiance[4].y, radiance[0].y) << "a red light";
}

AEROSTAT_AT_EVERY_WIDTH(Phong);

}  // namespace
}  // namespace aerostat::test
