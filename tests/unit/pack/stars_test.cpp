// Tests the catalogue of stars and their places in the sky.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "pack/pack_night.hpp"
#include "pack/star_catalogue.hpp"
#include "scene/celestial.hpp"

namespace aerostat::pack {
namespace {

using scene::detail::kDegree;

dvec3 equatorial(double ascension_deg, double declination_deg) {
  const double a = ascension_deg * kDegree, d = declination_deg * kDegree;
  return {std::cos(d) * std::cos(a), std::cos(d) * std::sin(a), std::sin(d)};
}

/// Returns the brightest star within a tenth of a degree of a place, or nothing.
const Star* star_at(const dvec3& place) {
  for (const Star& star : star_catalogue()) {
    if (glm::dot(star.direction, place) > std::cos(0.1 * kDegree)) return &star;
  }
  return nullptr;
}

struct Known {
  const char* name;
  double ascension_deg, declination_deg, magnitude, color_index;
};

// Places of 2000, magnitudes and B-V: D. Hoffleit and W. H. Warren, "The Bright Star Catalogue"
// (5th ed., 1991). Hipparcos's magnitudes are up to 0.05 off these.
constexpr Known kKnown[] = {
    {"Sirius", 101.2872, -16.7161, -1.46, 0.00}, {"Vega", 279.2347, 38.7837, 0.03, 0.00},
    {"Betelgeuse", 88.7929, 7.4071, 0.50, 1.85}, {"Polaris", 37.9529, 89.2642, 2.02, 0.60},
    {"Aldebaran", 68.9802, 16.5093, 0.85, 1.54}, {"Spica", 201.2983, -11.1614, 0.98, -0.23},
    {"Dubhe", 165.9319, 61.7511, 1.79, 1.07},    {"Alkaid", 206.8852, 49.3133, 1.86, -0.19},
};

TEST(Stars, AreWhereTheyAreKnownToBe) {
  EXPECT_EQ(star_catalogue().size(), 5044u);
  for (const Known& known : kKnown) {
    const Star* star = star_at(equatorial(known.ascension_deg, known.declination_deg));
    ASSERT_NE(star, nullptr) << known.name;
    const double off =
        glm::length(star->direction - equatorial(known.ascension_deg, known.declination_deg));
    EXPECT_LT(off / kDegree, 0.008) << known.name;
    EXPECT_NEAR(star->magnitude, known.magnitude, 0.08) << known.name;
    EXPECT_NEAR(star->color_index, known.color_index, 0.4) << known.name;
  }
  for (std::size_t i = 1; i < star_catalogue().size(); ++i) {
    EXPECT_GE(star_catalogue()[i].magnitude, star_catalogue()[i - 1].magnitude);
  }
}

TEST(Stars, HaveTheColoursOfTheirIndices) {
  const dvec3 sun = star_hue(0.65), red = star_hue(1.6), blue = star_hue(-0.2);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(sun[i], 1.0, 0.03);
  EXPECT_GT(red.x, 2.0 * red.z);
  EXPECT_GT(blue.z, 1.3 * blue.x);
}

TEST(Stars, RiseAndSetAsAnAlmanacSays) {
  // Azimuth and elevation without refraction on 15 January 2026, 20:00 UTC, at 46.5 degrees north
  // and 8 degrees east, as PyEphem 4.2.1 gives them. Proper motion since 2000 and the aberration,
  // which are left out here, are up to 0.01 degrees each.
  constexpr Known kSeen[] = {{"Sirius", 101.2872, -16.7161, 141.4047, 17.9511},
                             {"Vega", 279.2347, 38.7837, 332.6142, 1.2332},
                             {"Polaris", 37.9529, 89.2642, 359.7383, 47.0947},
                             {"Betelgeuse", 88.7929, 7.4071, 142.2314, 45.0536},
                             {"Capella", 79.1723, 45.9980, 86.4463, 78.6860}};
  const double days = 9511.0 + 8.0 / 24.0;  // from noon of 1 January 2000
  const auto rows =
      equator_rows(scene::detail::sidereal_deg_at(days) + 8.0, 46.5, 2000.0 + days / 365.25);
  for (const Known& seen : kSeen) {
    const dvec3 place = equatorial(seen.ascension_deg, seen.declination_deg);
    const dvec3 direction = rows[0] * place.x + rows[1] * place.y + rows[2] * place.z;
    const dvec3 expected = scene::detail::direction_of({seen.magnitude, seen.color_index});
    EXPECT_LT(glm::length(direction - expected) / kDegree, 0.03) << seen.name;
  }
}

}  // namespace
}  // namespace aerostat::pack
