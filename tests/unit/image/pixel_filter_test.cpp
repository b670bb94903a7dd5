// Tests the filter that mixes each pixel of a film with its neighbours.
#include "image/pixel_filter.hpp"

#include <cstddef>
#include <random>
#include <utility>

#include <gtest/gtest.h>

namespace aerostat::image {
namespace {

constexpr float kSide = 1.0f / 12.0f;

Film film_of(int width, int height) {
  Film film;
  film.width = width;
  film.height = height;
  film.whole = {width, height};
  film.radiance.assign(static_cast<std::size_t>(width * height), vec3(0.0f));
  return film;
}

vec3& at(Film& film, int x, int y) {
  return film.radiance[static_cast<std::size_t>(y * film.width + x)];
}

Film random_film(int width, int height) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> value(0.0f, 5.0f);
  Film film = film_of(width, height);
  for (vec3& pixel : film.radiance) {
    pixel.x = value(random);
    pixel.y = value(random);
    pixel.z = value(random);
  }
  for (const vec3& pixel : film.radiance) {
    film.alpha.push_back(pixel.x);
    film.distance_m.push_back(pixel.y);
  }
  return film;
}

/// Returns the part of a film that lies in a rectangle. `end` is the first pixel beyond it.
Film part_of(Film film, const glm::ivec2& first, const glm::ivec2& end) {
  cut_to(film, first, end);
  return film;
}

TEST(PixelFilter, SpreadsAPixelOverItsNeighbours) {
  Film film = film_of(9, 7);
  at(film, 4, 3) = vec3(1.0f, 2.0f, 0.0f);
  filter_pixels(film, kSide);
  const float weights[] = {kSide, 1.0f - 2.0f * kSide, kSide};
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 9; ++x) {
      const bool is_near = x >= 3 && x <= 5 && y >= 2 && y <= 4;
      const float expected = is_near ? weights[x - 3] * weights[y - 2] : 0.0f;
      EXPECT_NEAR(at(film, x, y).x, expected, 1e-7f) << x << ", " << y;
      EXPECT_NEAR(at(film, x, y).y, 2.0f * expected, 2e-7f) << x << ", " << y;
      EXPECT_EQ(at(film, x, y).z, 0.0f);
    }
  }
}

TEST(PixelFilter, KeepsAnEvenFilmUpToItsEdges) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 130}, {130, 1}, {5, 131}}) {
    Film film = film_of(width, height);
    for (vec3& pixel : film.radiance) pixel = vec3(3.0f);
    filter_pixels(film, kSide);
    for (const vec3& pixel : film.radiance) ASSERT_EQ(pixel.x, 3.0f);
  }
}

// Rows are filtered in bands of 64, and the part begins and ends inside of some.
TEST(PixelFilter, OfAPartAndItsNeighboursIsThatOfTheWhole) {
  const Film film = random_film(37, 211);
  const glm::ivec2 first(5, 20), end(30, 199);
  Film whole = film;
  filter_pixels(whole, kSide);
  whole = part_of(std::move(whole), first, end);
  Film part = part_of(film, first - 1, end + 1);
  filter_pixels(part, kSide);
  part = part_of(std::move(part), first, end);
  ASSERT_EQ(part.radiance.size(), whole.radiance.size());
  EXPECT_EQ(part.first, first);
  for (std::size_t i = 0; i < part.radiance.size(); ++i) {
    ASSERT_EQ(part.radiance[i], whole.radiance[i]) << i;
    ASSERT_EQ(part.alpha[i], whole.alpha[i]) << i;
  }
}

TEST(PixelFilter, LeavesDistancesAndWithoutWeightAll) {
  const Film film = random_film(8, 8);
  Film filtered = film;
  filter_pixels(filtered, kSide);
  EXPECT_TRUE(filtered.distance_m == film.distance_m);
  EXPECT_FALSE(filtered.radiance == film.radiance);
  Film plain = film;
  filter_pixels(plain, 0.0f);
  EXPECT_TRUE(plain.radiance == film.radiance);
}

}  // namespace
}  // namespace aerostat::image
