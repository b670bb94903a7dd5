// Tests geometry, Lambert's cosine, ambient light and shadows at pixels whose values are known in
// closed form.
#include <cmath>
#include <numbers>

#include "flat_land.hpp"

namespace aerostat::test {
namespace {

constexpr double kPi64 = std::numbers::pi;

TEST(FlatLand, LiesWhereItLies) {
  const auto scene = flat_land();
  const image::Film film = shared_session().render(resolved(scene));
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const auto i = static_cast<std::size_t>(y) * 64 + static_cast<std::size_t>(x);
      const double distance = glm::distance(point_under(scene, x, y), *scene.camera.position);
      ASSERT_NEAR(film.distance_m[i], distance, 1e-5 * distance) << x << ", " << y;
      ASSERT_LT(glm::distance(film.normal_ws[i], vec3(0.0f, 1.0f, 0.0f)), 1e-6f);
      ASSERT_LT(glm::distance(dvec3(film.albedo[i]), kAlbedo), 1e-6);
      ASSERT_EQ(film.object_id[i], static_cast<std::uint32_t>(scene::ObjectId::terrain));
      ASSERT_EQ(film.alpha[i], 1.0f);
    }
  }
}

TEST(FlatLand, IsBlackWithoutLight) {
  for_pixels(flat_land(),
             [](const dvec3&, const dvec3& radiance) { EXPECT_EQ(radiance, dvec3(0.0)); });
}

TEST(Sky, HasNoSurface) {
  auto scene = flat_land();
  scene.camera.target = {0.0, 2.0 * kEyeHeight, 0.0};
  const image::Film film = shared_session().render(resolved(scene));
  for (std::size_t i = 0; i < film.alpha.size(); ++i) {
    ASSERT_EQ(film.alpha[i], 0.0f);
    ASSERT_EQ(film.distance_m[i], kInfinity);
    ASSERT_EQ(film.object_id[i], 0u);
    ASSERT_EQ(film.albedo[i], vec3(0.0f));
    ASSERT_EQ(film.normal_ws[i], vec3(0.0f));
  }
}

/// Tests Lambert's law: L = albedo / pi * E * cos(angle to the sun).
TEST(Lambert, FollowsTheCosineOfTheSun) {
  auto scene = flat_land();
  scene.sun.irradiance = 3.0;
  scene.sun.color = {1.0f, 0.5f, 0.25f};
  const double scale = scene.sun.irradiance / kPi64;
  for (const double elevation_deg : {90.0, 60.0, 30.0, 10.0, 2.0}) {
    SCOPED_TRACE("sun at " + std::to_string(elevation_deg) + " degrees");
    const double elevation = glm::radians(elevation_deg);
    scene.sun.direction = {0.6 * std::cos(elevation), std::sin(elevation),
                           -0.8 * std::cos(elevation)};
    const dvec3 expected = kAlbedo * dvec3(scene.sun.color) * (scale * std::sin(elevation));
    for_pixels(scene,
               [&](const dvec3&, const dvec3& radiance) { expect_radiance(expected, radiance); });
  }
}

TEST(Lambert, GivesNothingFromBelow) {
  auto scene = flat_land();
  scene.sun.irradiance = 3.0;
  scene.sun.direction = glm::normalize(dvec3(0.5, -0.1, 0.2));
  scene.sun.shadows = false;
  for_pixels(scene, [](const dvec3&, const dvec3& radiance) { EXPECT_EQ(radiance, dvec3(0.0)); });
}

TEST(Ground, HasNoTreesWhereNoneAreAskedFor) {
  auto scene = flat_land();
  scene.sun.irradiance = kPi64;
  scene.sun.direction = {0.0, 1.0, 0.0};
  scene.terrain.size_m = 40000.0;
  scene.camera.position = {0.0, 5000.0, 0.0};
  for (const double forest_top_m : {0.0, 1000.0}) {
    scene.biome.ground.forest_top_m = forest_top_m;
    for_pixels(scene,
               [](const dvec3&, const dvec3& radiance) { expect_radiance(kAlbedo, radiance); });
  }
}

TEST(Filters, LeaveAnEvenSurfaceEven) {
  auto scene = flat_land();
  scene.sun.irradiance = kPi64;
  scene.sun.direction = {0.0, 1.0, 0.0};
  for (const auto filter : {scene::Filter::box, scene::Filter::tent, scene::Filter::gaussian}) {
    for (const int spp : {1, 2, 7, 16}) {
      SCOPED_TRACE("filter " + std::to_string(static_cast<int>(filter)) + ", " +
                   std::to_string(spp) + " samples");
      scene.image.filter = filter;
      scene.image.spp = spp;
      for_pixels(scene,
                 [](const dvec3&, const dvec3& radiance) { expect_radiance(kAlbedo, radiance); });
    }
  }
}

TEST(Shadings, AgreeOnAPlane) {
  auto scene = flat_land_under_a_sky();
  scene.sun.direction = glm::normalize(dvec3(1.0, 2.0, 0.5));
  const dvec3 expected = kAlbedo * (sky_light(scene) + sunlight(scene) * scene.sun.direction.y);
  for (const auto shading :
       {scene::Shading::flat, scene::Shading::gouraud, scene::Shading::phong}) {
    SCOPED_TRACE("shading " + std::to_string(static_cast<int>(shading)));
    scene.shading = shading;
    for_pixels(scene, [&](const dvec3&, const dvec3& radiance) {
      expect_radiance(expected, radiance, kAirBefore);
    });
  }
}

TEST(Shadings, DifferOnACurvedSurface) {
  auto scene = small_scene("snow", {160, 120, 1, 64});
  std::vector<image::Film> films;
  for (const auto shading :
       {scene::Shading::flat, scene::Shading::gouraud, scene::Shading::phong}) {
    scene.shading = shading;
    films.push_back(shared_session().render(resolved(scene)));
  }
  EXPECT_FALSE(same_bits(films[0], films[1]));
  EXPECT_FALSE(same_bits(films[0], films[2]));
  EXPECT_FALSE(same_bits(films[1], films[2]));
  for (std::size_t i = 0; i < films[0].object_id.size(); ++i) {
    ASSERT_EQ(films[0].distance_m[i], films[2].distance_m[i]) << "shading moves no surface";
  }
}

/// Returns a scene with a balloon of 18.8 m straight above and the sun at the zenith. The shadow of
/// the balloon is a disc around the origin. Gores bulge, so the rim is not a circle, and a ring
/// around it is left out.
scene::Scene under_the_balloon() {
  auto scene = flat_land_under_a_sky();
  scene.balloon.enabled = true;
  scene.balloon.position = {0.0, kEyeHeight + 5.0, 0.0};
  scene.balloon.diameter_m = 18.8;
  scene.camera.fov_y_deg = 70.0;
  return scene;
}

constexpr double kSurelyShaded = 8.6;
constexpr double kSurelyLit = 10.2;

TEST(Shadow, LeavesTheLightOfTheSky) {
  const auto scene = under_the_balloon();
  const dvec3 ambient = kAlbedo * sky_light(scene);
  const dvec3 lit = ambient + kAlbedo * sunlight(scene);
  int shaded_pixels = 0, lit_pixels = 0;
  for_pixels(scene, [&](const dvec3& point, const dvec3& radiance) {
    const double radius = glm::length(point);
    if (radius < kSurelyShaded) {
      expect_radiance(ambient, radiance, 0.03);
      ++shaded_pixels;
    } else if (radius > kSurelyLit) {
      expect_radiance(lit, radiance, kAirBefore);
      ++lit_pixels;
    }
  });
  EXPECT_GT(shaded_pixels, 300);
  EXPECT_GT(lit_pixels, 300);
}

TEST(Shadow, IsNotCastByALightThatCastsNone) {
  auto scene = under_the_balloon();
  scene.sun.shadows = false;
  const dvec3 lit = kAlbedo * (sky_light(scene) + sunlight(scene));
  for_pixels(scene, [&](const dvec3&, const dvec3& radiance) {
    expect_radiance(lit, radiance, kAirBefore);
  });
}

/// Tests that a lamp above the envelope is hidden, and that one under the basket is not hidden by
/// the objects behind it.
TEST(Shadow, EndsAtTheLamp) {
  auto scene = under_the_balloon();
  scene.air.density = 0.0;
  scene.sun.irradiance = 0.0;
  scene.lights = {{{0.0, 400.0, 0.0}, vec3(1.0f), 1e5, true}};
  for_pixels(scene, [&](const dvec3& point, const dvec3& radiance) {
    if (glm::length(point) < kSurelyShaded) {
      EXPECT_EQ(radiance, dvec3(0.0));
    }
  });
  scene.lights[0].position = {0.0, 28.0, 0.0};
  for_pixels(scene, [](const dvec3&, const dvec3& radiance) { EXPECT_GT(radiance.x, 0.01); });
}

}  // namespace
}  // namespace aerostat::test
