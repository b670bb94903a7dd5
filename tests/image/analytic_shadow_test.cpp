// Tests the balloon's penumbra and the sky that it hides against closed forms of its outline.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "air/atmosphere.hpp"
#include "flat_land.hpp"
#include "world/world.hpp"

namespace aerostat::test {
namespace {

constexpr double kPi64 = std::numbers::pi;
/// The number of sectors around the balloon. There are several for each gore.
constexpr std::size_t kSectors = 96;

/// Returns for each sector around the y axis the largest value of `measure` over the edges of the
/// balloon's triangles. The balloon is seen from far away, so it has fewer corners than there are
/// sectors.
template <typename Measure>
std::vector<double> outline(const scene::Scene& scene, Measure measure) {
  // The number of steps along an edge.
  constexpr int kSteps = 16;
  std::vector<double> largest(kSectors, 0.0);
  const world::World built = world::build(resolved(scene));
  for (const world::Object& object : *world::shape_of<world::Objects>(built, world::kBalloons)) {
    for (const uvec3& corners : object.mesh.triangles) {
      for (int i = 0; i < 3 * kSteps; ++i) {
        const dvec3 from(object.mesh.positions[corners[i / kSteps]]);
        const dvec3 to(object.mesh.positions[corners[(i / kSteps + 1) % 3]]);
        const dvec3 v = glm::mix(from, to, static_cast<double>(i % kSteps) / kSteps);
        const double turn = std::atan2(v.z, v.x) / (2.0 * kPi64) + 0.5;
        const auto sector = static_cast<std::size_t>(turn * kSectors) % kSectors;
        largest[sector] = std::max(largest[sector], measure(v));
      }
    }
  }
  return largest;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

scene::Scene under_a_balloon(scene::Scene scene, double height) {
  scene.balloon.enabled = true;
  scene.balloon.position = {0.0, height, 0.0};
  scene.image.filter = scene::Filter::box;
  scene.image.spp = 64;
  scene.sun.soft_shadows = true;
  scene.camera.fov_y_deg = 60.0;
  return scene;
}

/// Returns the share of a disc of radius 1 on one side of a straight edge at the distance `x` from
/// its middle.
double disc_beyond(double x) {
  const double at = std::clamp(x, -1.0, 1.0);
  return 0.5 + (at * std::sqrt(1.0 - at * at) + std::asin(at)) / kPi64;
}

/// Tests the penumbra. From a point of the ground, the sun is a disc behind the balloon's rim,
/// which is nearly straight.
TEST(SoftShadow, FallsOffAsTheSunsDiscComesOut) {
  auto scene = under_a_balloon(flat_land(), 600.0);
  scene.sun.irradiance = kPi64;
  scene.sun.direction = {0.0, 1.0, 0.0};
  const double rim = mean(outline(scene, [](const dvec3& v) { return std::hypot(v.x, v.z); }));
  const double rim_height = 600.0 + scene.balloon.diameter_m;
  const double spread = rim_height * std::tan(air::kSunRadius);
  int between = 0;
  for_pixels(scene, [&](const dvec3& point, const dvec3& radiance) {
    const double lit = radiance.x / kAlbedo.x;
    // The rim is curved and has bulges, so the tolerance is wide.
    EXPECT_NEAR(lit, disc_beyond((std::hypot(point.x, point.z) - rim) / spread), 0.12);
    between += lit > 0.1 && lit < 0.9 ? 1 : 0;
  });
  EXPECT_GT(between, 500);
}

TEST(SoftShadow, CanBeHard) {
  auto scene = under_a_balloon(flat_land(), 600.0);
  scene.sun.irradiance = kPi64;
  scene.sun.direction = {0.0, 1.0, 0.0};
  scene.sun.soft_shadows = false;
  scene.image.spp = 1;
  int lit = 0, dark = 0;
  for_pixels(scene, [&](const dvec3&, const dvec3& radiance) {
    const double share = radiance.x / kAlbedo.x;
    EXPECT_LT(std::min(share, std::abs(share - 1.0)), 1e-4);
    share > 0.5 ? ++lit : ++dark;
  });
  EXPECT_GT(lit, 100);
  EXPECT_GT(dark, 100);
}

image::Film render_with(scene::Scene scene, bool occlusion, double reach_m) {
  scene.sky.ambient_occlusion = occlusion;
  scene.sky.occlusion_m = reach_m;
  return shared_session().render(resolved(scene));
}

/// Tests ambient occlusion straight below the balloon. A body of revolution that reaches up to the
/// angle a from the vertical hides the share sin^2 a of the light onto the ground, and sends half
/// the ground's albedo of it instead.
TEST(AmbientOcclusion, HidesTheShareOfTheSkyThatTheBalloonCovers) {
  auto scene = under_a_balloon(flat_land_under_a_sky(), kEyeHeight + 5.0);
  scene.balloon.diameter_m = 40.0;
  const double share =
      mean(outline(scene, [](const dvec3& v) { return (v.x * v.x + v.z * v.z) / glm::dot(v, v); }));
  ASSERT_GT(share, 0.08);
  const image::Film open = render_with(scene, false, 1e5);
  const image::Film hidden = render_with(scene, true, 1e5);
  const dvec3 sky = kAlbedo * sky_light(scene);
  dvec3 lost(0.0);
  for (int y = 20; y < 28; ++y) {
    for (int x = 28; x < 36; ++x) {
      const auto i = static_cast<std::size_t>(y * 64 + x);
      lost += (dvec3(open.radiance[i]) - dvec3(hidden.radiance[i])) / 64.0;
    }
  }
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(lost[c] / sky[c], share * (1.0 - 0.5 * kAlbedo[c]), 0.03 * share);
}

TEST(AmbientOcclusion, SeesNothingBeyondItsReach) {
  const auto scene = under_a_balloon(flat_land_under_a_sky(), kEyeHeight + 5.0);
  EXPECT_TRUE(same_bits(render_with(scene, false, 1.0), render_with(scene, true, kEyeHeight)));
  EXPECT_FALSE(same_bits(render_with(scene, false, 1.0), render_with(scene, true, 1e3)));
}

TEST(AmbientOcclusion, LeavesOpenGroundAsItIs) {
  const auto scene = flat_land_under_a_sky();
  EXPECT_TRUE(same_bits(render_with(scene, false, 1.0), render_with(scene, true, 1e5)));
}

}  // namespace
}  // namespace aerostat::test
