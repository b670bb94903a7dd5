// Tests the glare around what is far brighter than white.
#include "image/glare.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace aerostat::image {
namespace {

Development glaring(double glare = 1.0) {
  Development development;
  development.glare = glare;
  return development;
}

/// Returns a dark film with a disc as bright as the sun, whose place and radius are shares of the
/// height.
Film film_with_sun(int width, int height, float radiance = 4000.0f, double radius = 0.02) {
  Film film;
  film.width = width;
  film.height = height;
  film.radiance.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                       vec3(0.01f));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double dx = (x + 0.5 - 0.5 * width) / height, dy = (y + 0.5) / height - 0.5;
      if (std::hypot(dx, dy) < radius) {
        film.radiance[static_cast<std::size_t>(y * width + x)] = radiance * vec3(1.0f, 0.9f, 0.7f);
      }
    }
  }
  return film;
}

/// Returns the radiance of a film with its glare.
std::vector<vec3> with_glare(const Film& film, const Development& development) {
  Glare glare({film.width, film.height}, development);
  glare.add(film);
  glare.spread();
  std::vector<vec3> light(film.radiance.begin(), film.radiance.end());
  if (!glare.is_there()) return light;
  for (int y = 0; y < film.height; ++y) {
    glare.apply(film, 0, y, film.width, &light[static_cast<std::size_t>(y * film.width)].x);
  }
  return light;
}

double sum_of(const auto& light) {
  double sum = 0.0;
  for (const vec3& one : light) sum += static_cast<double>(one.y);
  return sum;
}

/// Returns the light at a place that is given in heights from the middle of a picture.
vec3 at(const std::vector<vec3>& light, int width, int height, double x, double y) {
  // Places on the border of two pixels belong to the farther one.
  const int column = static_cast<int>(0.5 * width + x * height + 1e-6);
  const int row = static_cast<int>((0.5 + y) * height + 1e-6);
  return light[static_cast<std::size_t>(row * width + column)];
}

TEST(Glare, KeepsAllLightButThatBesideThePicture) {
  const Film film = film_with_sun(400, 300);
  const std::vector<vec3> light = with_glare(film, glaring());
  const double taken = kMostGlare * (sum_of(film.radiance) - 0.01 * 120000.0);
  const double lost = sum_of(film.radiance) - sum_of(light);
  EXPECT_GE(lost, 0.0);
  // The widest Gaussians are wider than the picture.
  EXPECT_LT(lost, 0.15 * taken);
  EXPECT_LT(light[150 * 400 + 200].y, film.radiance[150 * 400 + 200].y);
}

TEST(Glare, LeavesWhatIsNotFarBrighterThanWhite) {
  const Film film = film_with_sun(320, 200, static_cast<float>(kGlareFrom));
  EXPECT_EQ(develop(film, glaring()).rgb, develop(film, glaring(0.0)).rgb);
  const Film brighter = film_with_sun(320, 200, 40.0f * static_cast<float>(kGlareFrom));
  EXPECT_NE(develop(brighter, glaring()).rgb, develop(brighter, glaring(0.0)).rgb);
  // What counts is the exposed light.
  Development darker = glaring(), none = glaring(0.0);
  darker.exposure_ev = none.exposure_ev = -6.0;
  EXPECT_EQ(develop(brighter, darker).rgb, develop(brighter, none).rgb);
}

TEST(Glare, FallsWithTheDistanceAndIsRound) {
  const std::vector<vec3> light = with_glare(film_with_sun(600, 400), glaring());
  double last = INFINITY;
  for (double far = 0.08; far < 0.48; far += 0.02) {
    const vec3 right = at(light, 600, 400, far, 0.0), down = at(light, 600, 400, 0.0, far);
    const double side = far * std::sqrt(0.5);
    const vec3 aslant = at(light, 600, 400, side, side);
    EXPECT_LT(right.y, last);
    EXPECT_NEAR(down.y, right.y, 0.08f * right.y) << far;
    EXPECT_NEAR(aslant.y, right.y, 0.12f * right.y) << far;
    last = static_cast<double>(right.y);
  }
  // The colour is that of the light.
  const vec3 glow = at(light, 600, 400, 0.1, 0.0) - vec3(0.01f);
  EXPECT_NEAR(glow.z / glow.x, 0.7f, 0.01f);
}

TEST(Glare, LooksTheSameAtEverySize) {
  const std::vector<vec3> small = with_glare(film_with_sun(320, 180, 4000.0f, 0.05), glaring());
  const std::vector<vec3> large = with_glare(film_with_sun(960, 540, 4000.0f, 0.05), glaring());
  // The middles of pixels of both pictures.
  for (const double pixel : {15.5, 25.5, 45.5, 75.5}) {
    const double far = pixel / 180.0;
    const vec3 a = at(small, 320, 180, far, 0.0), b = at(large, 960, 540, far, 0.0);
    EXPECT_NEAR(a.y, b.y, 0.1f * b.y) << far;
  }
}

TEST(Glare, OfBandsIsThatOfTheWholePicture) {
  const Film film = film_with_sun(190, 611);
  const Pixels whole = develop(film, glaring());
  std::vector<Film> bands;
  for (const auto& [first, end] : {std::pair{0, 100}, {100, 301}, {301, 611}}) {
    Film band;
    band.width = film.width;
    band.height = end - first;
    band.first = {0, first};
    band.whole = {film.width, film.height};
    band.radiance.assign(film.radiance.begin() + first * film.width,
                         film.radiance.begin() + end * film.width);
    bands.push_back(std::move(band));
  }
  Glare glare({film.width, film.height}, glaring());
  for (const Film& band : bands) glare.add(band);
  glare.spread();
  std::vector<std::uint8_t> joined;
  for (const Film& band : bands) {
    const Pixels rows = develop(band, glaring(), glare);
    joined.insert(joined.end(), rows.rgb.begin(), rows.rgb.end());
  }
  EXPECT_TRUE(joined == whole.rgb);
  EXPECT_NE(joined, develop(film, glaring(0.0)).rgb);
}

TEST(Glare, IgnoresLightWithoutEnd) {
  Film film = film_with_sun(64, 48);
  film.radiance[100] = vec3(INFINITY);
  film.radiance[200] = vec3(NAN, 1.0f, 1.0f);
  const std::vector<vec3> light = with_glare(film, glaring());
  for (std::size_t i = 0; i < light.size(); ++i) {
    if (i != 100 && i != 200) {
      ASSERT_TRUE(is_finite(light[i])) << i;
    }
  }
}

TEST(Glare, OfTheSmallestPicturesIsTheirLight) {
  for (const glm::ivec2& size : {glm::ivec2(1, 1), {1, 7}, {9, 1}}) {
    const Film film = film_with_sun(size.x, size.y, 4000.0f, 10.0);
    for (const vec3& one : with_glare(film, glaring())) {
      EXPECT_GT(one.y, 0.9f * 3600.0f);
      EXPECT_LE(one.y, 3600.5f);
    }
  }
}

}  // namespace
}  // namespace aerostat::image
