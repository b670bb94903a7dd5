// Tests the moon's position, phase and light, sidereal time and the key light against published
// values.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "scene/celestial.hpp"
#include "scene/io.hpp"
#include "scene/key_light.hpp"
#include "scene/moon_position.hpp"
#include "scene/moonlight.hpp"
#include "scene/scene.hpp"
#include "scene/sun_position.hpp"

namespace aerostat::scene {
namespace {

using detail::kDegree;

double days(const char* date, const char* time) {
  return detail::days_from_2000(date, time).value();
}

/// Returns an angle in degrees as 0 to 360.
double turn(double degrees) {
  return degrees - 360.0 * std::floor(degrees / 360.0);
}

TEST(SiderealTime, IsThatOfMeeus) {
  // Examples 12.a and 12.b: 13h 10m 46.3668s and 8h 34m 57.0896s.
  EXPECT_NEAR(turn(detail::sidereal_deg_at(days("1987-04-10", "00:00"))), 197.693195, 1e-5);
  EXPECT_NEAR(turn(detail::sidereal_deg_at(days("1987-04-10", "19:21"))), 128.7378734, 1e-5);
}

TEST(MoonPosition, IsThatOfMeeus) {
  // Example 47.a at 0h dynamical time, which is 59 s earlier by the clock of 1992. The moon moves
  // by 0.009 degrees in a minute.
  const detail::MoonPlace moon = detail::moon_place_at(days("1992-04-11", "23:59"));
  EXPECT_NEAR(turn(moon.place.right_ascension / kDegree), 134.688470, 0.01);
  EXPECT_NEAR(moon.place.declination / kDegree, 13.768368, 0.01);
  EXPECT_NEAR(moon.distance_km, 368409.7, 50.0);
}

/// A position of the moon without refraction by XEphem's library (E. C. Downey), as PyEphem 4.2.1
/// gives it.
struct Almanac {
  const char *date, *time;
  double latitude_deg, longitude_deg, azimuth_deg, elevation_deg, distance_km;
};

TEST(MoonPosition, IsThatOfAnotherAlmanac) {
  constexpr Almanac kMoons[] = {
      {"1992-04-12", "00:00", 0.0, 0.0, 285.0395, 22.5958, 368404.9},
      {"2024-06-22", "01:08", 46.5, 8.0, 201.8509, 11.0039, 380041.3},
      {"2025-01-13", "22:27", 51.4779, 0.0, 131.9635, 56.9549, 381416.2},
      {"2003-10-17", "19:30:30", 39.742476, -105.1786, 300.0603, 5.1421, 398315.3},
      {"1999-12-22", "18:00", -33.9, 18.4, 62.7601, 1.8603, 356742.4},
      {"2031-05-03", "03:20", 64.1, -21.9, 259.8579, 2.9694, 386162.6},
  };
  for (const Almanac& given : kMoons) {
    SCOPED_TRACE(given.date);
    const double when = days(given.date, given.time);
    const detail::MoonSeen moon =
        detail::moon_seen_at(when, given.latitude_deg, given.longitude_deg);
    const double lifted =
        given.elevation_deg +
        1.02 / 60.0 /
            std::tan((given.elevation_deg + 10.3 / (given.elevation_deg + 5.11)) * kDegree);
    // 0.01 degrees of the orbit, 0.01 of the parallax, and up to 0.01 of the two clocks.
    EXPECT_NEAR(turn(moon.angles.azimuth_deg), given.azimuth_deg,
                0.03 / std::cos(given.elevation_deg * kDegree));
    EXPECT_NEAR(moon.angles.elevation_deg, lifted, 0.03);
    EXPECT_NEAR(detail::moon_place_at(when).distance_km, given.distance_km, 60.0);
  }
}

dvec3 equatorial(double ascension_deg, double declination_deg) {
  const double a = ascension_deg * kDegree, d = declination_deg * kDegree;
  return {std::cos(d) * std::cos(a), std::cos(d) * std::sin(a), std::sin(d)};
}

TEST(MoonPhase, IsThatOfMeeus) {
  // Example 48.a: the moon's phase angle, its lit share and the angle of its bright limb.
  const dvec3 moon = equatorial(134.6885, 13.7684), sun = equatorial(20.6579, 8.6964);
  const MoonPhase phase = moon_phase(moon, 368410.0, sun);
  EXPECT_NEAR(phase.phase_rad / kDegree, 69.0756, 0.02);
  EXPECT_NEAR(phase.lit_share, 0.6786, 0.0003);
  const dvec3 east = glm::normalize(glm::cross(dvec3(0.0, 0.0, 1.0), moon));
  const dvec3 north = glm::cross(moon, east);
  const double limb = std::atan2(glm::dot(phase.to_sun, east), glm::dot(phase.to_sun, north));
  EXPECT_NEAR(turn(limb / kDegree), 285.0, 0.1);
}

TEST(MoonLight, HasThePublishedMagnitudes) {
  EXPECT_NEAR(moon_magnitude(0.0, kMeanMoonDistanceKm), -12.73, 1e-9);
  // A half moon has 8 to 9 % of the light of a full one (C. W. Allen, section 66: 0.083).
  const auto share = [](double degrees) {
    return moon_share_of_sun(degrees * kDegree, kMeanMoonDistanceKm).y;
  };
  EXPECT_NEAR(share(90.0) / share(0.0), 0.083, 0.01);
  // At the zenith, 0.267 lx of a full moon reach the ground (P. M. Janiczek and J. A. DeYoung, US
  // Naval Observatory Circular 171, 1987). Clear air lets 0.75 to 0.85 of it through.
  EXPECT_NEAR(share(0.0) * 133100.0 * 0.8, 0.267, 0.03);
  EXPECT_NEAR(share(0.0) / moon_share_of_sun(0.0, 2.0 * kMeanMoonDistanceKm).y, 4.0, 1e-9);
  for (double degrees = 5.0; degrees < 180.0; degrees += 5.0) {
    EXPECT_LT(share(degrees), share(degrees - 5.0)) << degrees;
  }
}

Scene night(double sun_deg, double moon_deg) {
  Scene scene = defaults(BiomeKind::snow, View::outside);
  scene.sun.direction = detail::direction_of({90.0, sun_deg});
  scene.moon = {true, -90.0, moon_deg, kMeanMoonDistanceKm};
  return scene;
}

TEST(KeyLight, IsTheMoonWhenTheSunIsWellDown) {
  EXPECT_FALSE(key_light(night(-3.9, 20.0)).is_moon);
  EXPECT_FALSE(key_light(night(-20.0, -5.0)).is_moon);
  Scene scene = night(-20.0, 20.0);
  const KeyLight key = key_light(scene);
  EXPECT_TRUE(key.is_moon);
  EXPECT_NEAR(key.direction.y, std::sin(20.0 * kDegree), 1e-12);
  EXPECT_NEAR(key.irradiance.y, 5.0 * moon_share_of_sun(0.0, kMeanMoonDistanceKm).y,
              0.01 * key.irradiance.y);
  scene.moon.enabled = false;
  EXPECT_EQ(key_light(scene).direction, scene.sun.direction);
}

TEST(SceneMoon, FollowsFromDateAndPlaceUnlessItIsGiven) {
  const std::string sun =
      R"("sun": {"date": "2024-06-22", "time": "01:08", "latitude_deg": 46.5, "longitude_deg": 8})";
  const Scene scene = read_text("{\"version\": 1, " + sun + "}", "test");
  EXPECT_TRUE(scene.moon.enabled);
  EXPECT_NEAR(turn(scene.moon.azimuth_deg), 201.85, 0.03);
  EXPECT_NEAR(turn(scene.stars.sidereal_deg), 295.715, 0.01) << "as PyEphem 4.2.1 gives it";
  EXPECT_EQ(scene.stars.latitude_deg, 46.5);
  const Scene given = read_text(
      "{\"version\": 1, " + sun + R"(, "moon": {"enabled": false, "azimuth_deg": 7}})", "test");
  EXPECT_FALSE(given.moon.enabled);
  EXPECT_EQ(given.moon.azimuth_deg, 7.0);
  EXPECT_FALSE(read_text(R"({"version": 1})", "test").moon.enabled);
}

TEST(SceneMood, SetsDefaultsThatTheSceneMayChange) {
  const Scene golden = read_text(R"({"version": 1, "mood": "golden"})", "test");
  EXPECT_NEAR(detail::angles_of(golden.sun.direction).elevation_deg, 6.5, 1e-9);
  EXPECT_EQ(golden.mood, Mood::golden);
  const Scene higher = read_text(
      R"({"version": 1, "mood": "golden", "sun": {"elevation_deg": 9}, "haze": {"visibility_m": 70000}})",
      "test");
  EXPECT_NEAR(detail::angles_of(higher.sun.direction).elevation_deg, 9.0, 1e-9);
  EXPECT_EQ(higher.haze.visibility_m, 70000.0);
  EXPECT_EQ(higher.image.vignette, golden.image.vignette);
  const Scene set = read_text(R"({"version": 1})", "test", {{"/mood", "night"}});
  EXPECT_TRUE(key_light(set).is_moon);
}

TEST(SceneMood, IsWrittenSoThatReadingGivesTheSame) {
  for (const char* mood : {"dawn", "noon", "golden", "dusk", "night", "storm", "mist"}) {
    for (const char* biome : {"snow", "tropical", "sand"}) {
      const std::string text =
          std::string(R"({"version": 1, "biome": ")") + biome + R"(", "mood": ")" + mood + "\"}";
      const std::string written = write_text(read_text(text, "test"));
      EXPECT_EQ(write_text(read_text(written, "test")), written) << mood << " " << biome;
    }
  }
}

}  // namespace
}  // namespace aerostat::scene
