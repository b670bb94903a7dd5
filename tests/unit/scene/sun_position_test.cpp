// Tests the position of the sun against published values.

#include "scene/sun_position.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "scene/io.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene::detail {
namespace {

SunAngles at(const char* date, const char* time, double latitude_deg, double longitude_deg) {
  const auto days = days_from_2000(date, time);
  EXPECT_TRUE(days.has_value()) << date << " " << time;
  return sun_angles_at(days.value_or(0.0), latitude_deg, longitude_deg);
}

double azimuth_of(const SunAngles& angles) {
  return angles.azimuth_deg < 0.0 ? angles.azimuth_deg + 360.0 : angles.azimuth_deg;
}

TEST(SunPosition, OfTheNrelPaper) {
  // The values are from I. Reda and A. Andreas, "Solar Position Algorithm for Solar Radiation
  // Applications", NREL 2008, table A5.1. Their refraction is that of thinner air and 0.004 degrees
  // less.
  const SunAngles sun = at("2003-10-17", "12:30:30-07:00", 39.742476, -105.1786);
  EXPECT_NEAR(90.0 - sun.elevation_deg, 50.11162, 0.01);
  EXPECT_NEAR(azimuth_of(sun), 194.34024, 0.01);
}

/// Returns the declination of the sun. From a pole, the sun stands as high as its declination, and
/// refraction does not lift it below the horizon.
double declination(const char* date, const char* time) {
  const double north = at(date, time, 90.0, 0.0).elevation_deg;
  return north < -1.0 ? north : -at(date, time, -90.0, 0.0).elevation_deg;
}

TEST(SunPosition, HasThePublishedDeclinations) {
  // The value is from Meeus, "Astronomical Algorithms", example 25.a, at 0h dynamical time, which
  // is a minute later by the clock.
  EXPECT_NEAR(declination("1992-10-13", "00:00"), -7.78507, 0.005);
  // The times are the solstices of 2024.
  EXPECT_NEAR(declination("2024-06-20", "20:51"), 23.4386, 0.005);
  EXPECT_NEAR(declination("2024-12-21", "09:20"), -23.4386, 0.005);
}

TEST(SunPosition, StandsOverTheEquatorAtTheEquinox) {
  // The time is 20 March 2024, 03:06 UTC. The equation of time is -7.4 minutes.
  const double noon_longitude = 180.0 - 15.0 * 3.1 + 7.4 / 4.0;
  EXPECT_NEAR(at("2024-03-20", "03:06", 0.0, noon_longitude).elevation_deg, 90.0, 0.1);
}

TEST(SunPosition, IsLiftedByTheAirAtTheHorizon) {
  // At the equinox the centre of the sun passes the true horizon of the equator at 06:00 sun time.
  const double lifted = at("2024-03-20", "06:07:24", 0.0, 0.0).elevation_deg;
  EXPECT_NEAR(lifted, 29.0 / 60.0, 0.06) << "the mean refraction of a star that rises";
}

TEST(SunTime, KnowsOffsets) {
  const auto utc = days_from_2000("2024-06-21", "04:30");
  EXPECT_EQ(days_from_2000("2024-06-21", "06:30+02:00"), utc);
  EXPECT_EQ(days_from_2000("2024-06-20", "23:30-05:00"), utc);
  EXPECT_EQ(days_from_2000("2024-06-21", "04:30:00Z"), utc);
  EXPECT_EQ(days_from_2000("2000-01-01", "12:00"), 0.0);
}

TEST(SunTime, RefusesWhatIsNone) {
  for (const char* date : {"2023-02-29", "2024-13-01", "24-06-21", "2024-6-21", "1899-12-31", "",
                           "2024-06-21x", "-024-06-21"}) {
    EXPECT_FALSE(days_from_2000(date, "12:00").has_value()) << date;
  }
  for (const char* time : {"24:00", "12:60", "12", "12:00:60", "12:00+2", "12:00 Z", "", "1:00"}) {
    EXPECT_FALSE(days_from_2000("2024-06-21", time).has_value()) << time;
  }
}

TEST(SceneSun, CanBeGivenByDateAndPlace) {
  const std::string sun =
      R"({"version": 1, "sun": {"date": "2003-10-17", "time": "12:30:30-07:00",
          "latitude_deg": 39.742476, "longitude_deg": -105.1786}})";
  const Scene scene = read_text(sun, "sun.json");
  EXPECT_NEAR(std::asin(scene.sun.direction.y) * 180.0 / kPi, 39.888, 0.01);
  // A later choice of a direction or of another hour replaces the earlier one.
  const Scene turned = read_text(sun, "sun.json", {{"/sun/azimuth_deg", "90"}});
  EXPECT_NEAR(turned.sun.direction.z, 0.0, 1e-9);
  const Scene later = read_text(sun, "sun.json", {{"/sun/time", "\"13:30:30-07:00\""}});
  EXPECT_LT(later.sun.direction.y, scene.sun.direction.y);
}

}  // namespace
}  // namespace aerostat::scene::detail
