// Tests the white balance and the vignette.
#include "image/white.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "image/write.hpp"

namespace aerostat::image {
namespace {

double luminance(const dvec3& c) {
  return 0.2126390 * c.x + 0.7151687 * c.y + 0.0721923 * c.z;
}

void expect_grey(const dvec3& c, double tolerance) {
  EXPECT_NEAR(c.x, c.y, tolerance);
  EXPECT_NEAR(c.z, c.y, tolerance);
}

TEST(WhiteBalance, MakesWhiteOfTheLightAndKeepsItsLuminance) {
  for (const dvec3& white : {dvec3(1.0, 0.9, 0.7), dvec3(3.0, 4.0, 5.0), dvec3(0.2, 0.1, 0.01)}) {
    const dvec3 found = white_balance(white, 1.0) * white;
    expect_grey(found, 1e-6 * luminance(white));
    EXPECT_NEAR(found.y, luminance(white), 1e-5 * luminance(white));
    for (const double degree : {0.0, 0.3, 0.7}) {
      const glm::dmat3 part = white_balance(white, degree);
      EXPECT_NEAR(luminance(part * white), luminance(white), 1e-9 * luminance(white));
    }
  }
}

TEST(WhiteBalance, GoesAsFarAsItIsAsked) {
  const dvec3 warm(1.0, 0.8, 0.5);
  double blue_share = warm.z / warm.x;
  for (const double degree : {0.25, 0.5, 0.75, 1.0}) {
    const dvec3 found = white_balance(warm, degree) * warm;
    EXPECT_GT(found.z / found.x, blue_share);
    blue_share = found.z / found.x;
  }
  const dvec3 none = white_balance(warm, 0.0) * dvec3(0.3, 0.5, 0.7);
  EXPECT_LT(glm::distance(none, dvec3(0.3, 0.5, 0.7)), 1e-9);
}

/// Compares black bodies with CIE 15 as ratios of linear Rec. 709.
TEST(WhiteBalance, KnowsBlackBodies) {
  // A black body of 2856 K is illuminant A with x = 0.44757, y = 0.40745.
  const dvec3 a = black_body(2856.0);
  const double x = 0.4123908 * a.x + 0.3575843 * a.y + 0.1804808 * a.z;
  const double z = 0.0193308 * a.x + 0.1191948 * a.y + 0.9505322 * a.z;
  EXPECT_NEAR(luminance(a), 1.0, 1e-5);
  EXPECT_NEAR(x / (x + 1.0 + z), 0.44757, 1e-3);
  EXPECT_NEAR(1.0 / (x + 1.0 + z), 0.40745, 1e-3);
  for (double kelvin = 1700.0; kelvin < 24000.0; kelvin *= 1.1) {
    const dvec3 cooler = black_body(kelvin), hotter = black_body(kelvin * 1.1);
    EXPECT_LT(cooler.z, hotter.z) << kelvin;
    EXPECT_GT(cooler.x, hotter.x) << kelvin;
  }
}

TEST(WhiteBalance, ByTemperatureLeaves6504AsItIs) {
  const dvec3 color(0.2, 0.5, 0.9);
  EXPECT_LT(glm::distance(white_balance_for(6504.0) * color, color), 1e-9);
  // A lower temperature removes the yellow of such light, so a grey turns blue.
  const dvec3 grey = white_balance_for(3200.0) * dvec3(0.5);
  EXPECT_GT(grey.z, grey.x * 1.3);
  EXPECT_LT((white_balance_for(12000.0) * dvec3(0.5)).z, 0.5);
}

TEST(WhiteBalance, TakesDaylightThatIsNone) {
  for (const dvec3& none : {dvec3(0.0), dvec3(std::nan(""))}) {
    EXPECT_EQ(automatic_white_balance(none), glm::dmat3(1.0));
  }
}

TEST(WhiteBalance, IsDoneWhenDeveloping) {
  Film film;
  film.width = film.height = 8;
  const vec3 warm(0.5f, 0.4f, 0.25f);
  film.radiance.assign(64, warm);
  Development development;
  development.white_balance = white_balance(dvec3(warm), 1.0);
  const Pixels pixels = develop(film, development);
  EXPECT_LE(std::abs(pixels.rgb[0] - pixels.rgb[2]), 1);
  EXPECT_GT(develop(film, 0.0).rgb[0], develop(film, 0.0).rgb[2] + 20);
}

TEST(Vignette, LosesItsShareInTheCornersAndNothingInTheMiddle) {
  for (const double lost : {0.1, 0.5, 0.9}) {
    EXPECT_EQ(vignette_share(0.0, lost), 1.0);
    EXPECT_NEAR(vignette_share(1.0, lost), 1.0 - lost, 1e-12);
    // The share is the fourth power of a cosine: cos^4 = 1 / (1 + tan^2)^2.
    const double tangent = 0.5 * std::sqrt(1.0 / std::sqrt(1.0 - lost) - 1.0);
    EXPECT_NEAR(vignette_share(0.5, lost), std::pow(std::cos(std::atan(tangent)), 4.0), 1e-12);
  }
  EXPECT_EQ(vignette_share(1.0, 0.0), 1.0);
}

TEST(Vignette, OfACropIsThatOfThePicture) {
  Film film;
  film.width = 16;
  film.height = 8;
  film.radiance.assign(128, vec3(0.3f));
  Development development;
  development.vignette = 0.6;
  const Pixels all = develop(film, development);
  EXPECT_LT(all.rgb[0] + 20, all.rgb[3 * (4 * 16 + 8)]);
  film.width = 8;
  film.radiance.assign(64, vec3(0.3f));
  film.whole = {16, 8};
  film.first = {8, 0};
  const Pixels right = develop(film, development);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const auto at = static_cast<std::size_t>(3 * (y * 8 + x));
      EXPECT_EQ(right.rgb[at], all.rgb[static_cast<std::size_t>(3 * (y * 16 + x + 8))]);
    }
  }
}

}  // namespace
}  // namespace aerostat::image
