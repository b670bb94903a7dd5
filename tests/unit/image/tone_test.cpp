// Tests properties and closed-form values of the tone curve from radiance to display values.

#include "image/tone.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/error.hpp"
#include "image/write.hpp"

namespace aerostat::image {
namespace {

TEST(ToneCurve, IsStrictlyIncreasingUpToTheWhitePoint) {
  double before = tone_curve(0.0);
  EXPECT_EQ(before, 0.0);
  for (double x = 1e-4; x < kWhitePoint; x *= 1.01) {
    const double now = tone_curve(x);
    EXPECT_GT(now, before) << "at " << x;
    EXPECT_LT(now, 1.0) << "at " << x;
    before = now;
  }
  EXPECT_NEAR(before, 1.0, 1e-2);
  EXPECT_EQ(tone_curve(kWhitePoint), 1.0);
  EXPECT_EQ(tone_curve(1e30), 1.0);
}

TEST(ToneCurve, MeetsMiddleGrey) {
  EXPECT_NEAR(tone_curve(0.18), 0.19, 1e-9);
  // The contrast there is about that of the scene, as the slope in a log-log diagram.
  const double slope = std::log(tone_curve(0.19) / tone_curve(0.17)) / std::log(0.19 / 0.17);
  EXPECT_GT(slope, 0.95);
  EXPECT_LT(slope, 1.25);
}

TEST(ToneCurve, IsContinuousAtTheWhitePoint) {
  EXPECT_NEAR(tone_curve(kWhitePoint * (1.0 - 1e-9)), 1.0, 1e-6);
}

TEST(ToneCurve, KeepsDetailInSunlitSnow) {
  // Snow of albedo 0.9 in a sun of irradiance pi and a patch that is 3 % darker stay different in
  // eight bits and below white.
  const double lit = 255.0 * srgb_from_linear(tone_curve(0.9));
  const double darker = 255.0 * srgb_from_linear(tone_curve(0.9 * 0.97));
  EXPECT_LT(lit, 250.0);
  EXPECT_GT(lit, 170.0);
  EXPECT_GT(lit - darker, 1.0);
}

TEST(ToneMap, KeepsGreysGrey) {
  for (double x : {0.0, 0.001, 0.18, 0.9, 3.0, 5.9, 100.0}) {
    const dvec3 display = tone_map(dvec3{x});
    EXPECT_DOUBLE_EQ(display.x, tone_curve(x));
    EXPECT_DOUBLE_EQ(display.y, display.x);
    EXPECT_DOUBLE_EQ(display.z, display.x);
  }
}

// Returns the place of the middle component between the others, which fixes the hue in HSV's
// circle.
double middle_share(const dvec3& c) {
  const double lo = std::min({c.x, c.y, c.z});
  const double hi = std::max({c.x, c.y, c.z});
  return (c.x + c.y + c.z - lo - hi - lo) / (hi - lo);
}

TEST(ToneMap, DoesNotTurnHue) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.01, 4.0);
  for (int i = 0; i < 1000; ++i) {
    const dvec3 color{uniform(random), uniform(random), uniform(random)};
    const dvec3 display = tone_map(color);
    EXPECT_NEAR(middle_share(display), middle_share(color), 1e-6);
  }
}

TEST(ToneMap, DesaturatesTowardsWhiteOnly) {
  const dvec3 orange{1.0, 0.5, 0.1};
  double before = 1.0;
  for (double gain = 0.05; gain < 6.0; gain *= 1.2) {
    const dvec3 display = tone_map(orange * gain);
    const double saturation = 1.0 - display.z / display.x;
    EXPECT_LE(saturation, before + 1e-12);
    before = saturation;
  }
  EXPECT_LT(before, 0.1);
  const dvec3 dim = tone_map(orange * 0.2);
  EXPECT_NEAR(dim.y / dim.x, 0.5, 1e-3);
}

TEST(ToneMap, TakesWhatIsNoColour) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(tone_map({nan, -1.0, 0.0}), dvec3(0.0));
  EXPECT_EQ(tone_map({infinity, 0.2, nan}), dvec3(1.0));
}

TEST(Srgb, HasTheValuesOfTheStandard) {
  EXPECT_EQ(srgb_from_linear(0.0), 0.0);
  EXPECT_NEAR(srgb_from_linear(1.0), 1.0, 1e-15);
  EXPECT_NEAR(srgb_from_linear(0.002), 0.02584, 1e-12);
  EXPECT_NEAR(srgb_from_linear(0.18), 0.4613561295, 1e-9);
  EXPECT_NEAR(srgb_from_linear(0.5), 0.7353569831, 1e-9);
  EXPECT_NEAR(srgb_from_linear(0.0031308), srgb_from_linear(0.0031309), 1e-5);
  EXPECT_EQ(srgb_from_linear(-1.0), 0.0);
  EXPECT_NEAR(srgb_from_linear(7.0), 1.0, 1e-15);
}

TEST(Srgb, IsInvertible) {
  for (int i = 0; i <= 255; ++i) {
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb(i / 255.0)), i / 255.0, 2e-8);
  }
}

TEST(Dither, KeepsBlackAndWhiteAndEightBitValues) {
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      EXPECT_EQ(quantise(0.0, x, y), 0);
      EXPECT_EQ(quantise(1.0, x, y), 255);
      EXPECT_EQ(quantise(100.0 / 255.0, x, y), 100);
    }
  }
}

TEST(Dither, IsRightOnTheMeanAndNeverFartherThanOneStep) {
  for (double value : {0.3, 17.25, 99.5, 200.99}) {
    double sum = 0.0;
    for (int y = 8; y < 16; ++y) {
      for (int x = 16; x < 24; ++x) {
        const int step = quantise(value / 255.0, x, y);
        EXPECT_LE(std::abs(step - value), 1.0);
        sum += step;
      }
    }
    EXPECT_NEAR(sum / 64.0, value, 1.0 / 64.0);
  }
}

TEST(Develop, BreaksUpBands) {
  // The sky is so even that it spans one step of eight bits. Rounding alone would be wrong by up to
  // half a step over hundreds of adjacent pixels.
  Film film;
  film.width = 512;
  film.height = 8;
  for (int i = 0; i < film.width * film.height; ++i) {
    film.radiance.push_back(vec3(0.3f + 1e-5f * static_cast<float>(i % film.width)));
  }
  const Pixels pixels = develop(film, 0.0);
  for (int block = 0; block < film.width; block += 8) {
    double sum = 0.0;
    for (int i = 0; i < 64; ++i) sum += pixels.rgb[3 * (block + i % 8 + i / 8 * film.width)];
    const double middle = tone_curve(0.3 + 1e-5 * (block + 3.5));
    EXPECT_NEAR(sum / 64.0, 255.0 * srgb_from_linear(middle), 2.0 / 64.0);
  }
}

TEST(Develop, ExposesInStops) {
  Film film;
  film.width = film.height = 1;
  film.radiance = {vec3(0.045f)};
  const double expected = 255.0 * srgb_from_linear(0.19);
  EXPECT_NEAR(develop(film, 2.0).rgb[0], expected, 1.0);
  EXPECT_LT(develop(film, 0.0).rgb[0], expected - 40.0);
}

Film grey_film(const std::vector<float>& radiances) {
  Film film;
  film.width = static_cast<int>(radiances.size());
  film.height = 1;
  for (const float radiance : radiances) film.radiance.push_back(vec3(radiance));
  return film;
}

TEST(AutomaticExposure, BringsAnEvenPictureToGrey) {
  for (const float light : {4e-3f, 0.02f, 0.25f, 30.0f}) {
    const double ev = automatic_exposure_ev(grey_film(std::vector<float>(100, light)));
    // If nothing is bright, the exposure rises by 0.45 stops above the middle grey.
    EXPECT_NEAR(static_cast<double>(light) * std::exp2(ev), 0.21 * std::exp2(0.45), 1e-6);
  }
}

TEST(AutomaticExposure, FollowsTheLightOfTheScene) {
  std::vector<float> radiances;
  for (int i = 0; i < 1000; ++i) radiances.push_back(0.05f + 0.001f * static_cast<float>(i));
  const double ev = automatic_exposure_ev(grey_film(radiances));
  for (float& radiance : radiances) radiance *= 8.0f;
  EXPECT_NEAR(automatic_exposure_ev(grey_film(radiances)), ev - 3.0, 1e-4);
}

TEST(AutomaticExposure, HeedsNeitherTheSunNorADarkForeground) {
  std::vector<float> radiances(1000, 0.1f);
  const double ev = automatic_exposure_ev(grey_film(radiances));
  std::fill_n(radiances.begin(), 180, 1e-5f);
  std::fill_n(radiances.rbegin(), 5, 1e4f);
  EXPECT_NEAR(automatic_exposure_ev(grey_film(radiances)), ev, 1e-6);
}

TEST(AutomaticExposure, DoesNotClipSnow) {
  std::vector<float> radiances(1000, 0.02f);
  std::fill_n(radiances.begin(), 100, 0.9f);
  const double ev = automatic_exposure_ev(grey_film(radiances));
  EXPECT_LT(255.0 * srgb_from_linear(tone_curve(0.9 * std::exp2(ev))), 250.0);
}

TEST(AutomaticExposure, GoesUpWhereTheLightsLeaveRoom) {
  // The middle at 0.1 asks for 1.07 stops. The lights, a twentieth of the picture, would allow
  // another half of a stop.
  std::vector<float> radiances(1000, 0.1f);
  std::fill_n(radiances.begin(), 51, static_cast<float>(1.5 / 2.1 / std::sqrt(2.0)));
  const double wanted = std::log2(2.1);
  EXPECT_NEAR(automatic_exposure_ev(grey_film(radiances)), wanted + 0.3 * 0.5, 1e-4);
}

TEST(AutomaticExposure, LetsAGlitterClipRatherThanLoseTheRest) {
  std::vector<float> radiances(1000, 0.1f);
  const double ev = automatic_exposure_ev(grey_film(radiances));
  std::fill_n(radiances.begin(), 51, 500.0f);
  EXPECT_NEAR(automatic_exposure_ev(grey_film(radiances)), ev - 0.45 - 2.0, 1e-6);
}

/// Returns the exposed value of an even picture with this luminance in cd/m^2.
double shown_candelas(double candelas) {
  const double radiance = candelas / 26620.0;
  const Film film = grey_film(std::vector<float>(100, static_cast<float>(radiance)));
  return radiance * std::exp2(automatic_exposure_ev(film));
}

TEST(AutomaticExposure, LeavesDuskAndNightDark) {
  const double day = shown_candelas(3000.0);
  // The expected ratio is that of Krawczyk's key 1.03 - 2 / (2 + log10(L + 1)) to the key of 100
  // cd/m^2.
  EXPECT_NEAR(shown_candelas(1.0) / day, 0.1607 / 0.5305, 0.002);
  // Below 0.01 cd/m^2, a quarter of each stop remains visible.
  EXPECT_NEAR(shown_candelas(1.7e-4) / day, 0.0300 / 0.5305 * std::pow(0.017, 0.25), 0.0005);
  double before = 0.0;
  for (double candelas = 1e-4; candelas < 90.0; candelas *= 1.5) {
    const double now = shown_candelas(candelas);
    EXPECT_GT(now, before) << candelas << ": what is brighter is shown brighter";
    before = now;
  }
  EXPECT_NEAR(shown_candelas(110.0), day, 1e-6) << "as daylight";
}

TEST(AutomaticExposure, LetsLampsClipByNight) {
  std::vector<float> radiances(1000, 1e-8f);
  const double ev = automatic_exposure_ev(grey_film(radiances));
  std::fill_n(radiances.begin(), 30, 1e-2f);
  EXPECT_NEAR(automatic_exposure_ev(grey_film(radiances)), ev, 0.5);
}

TEST(AutomaticExposure, TakesAPictureWithoutLight) {
  EXPECT_EQ(automatic_exposure_ev(grey_film({0.0f, 0.0f})), 0.0);
  EXPECT_EQ(automatic_exposure_ev({}), 0.0);
}

/// Returns a film with light of many brightnesses and some pixels without light.
Film varied_film(int width, int height) {
  Film film;
  film.width = width;
  film.height = height;
  std::mt19937 random(43);
  std::normal_distribution<float> exponent(-3.0f, 5.0f);
  for (int i = 0; i < width * height; ++i)
    film.radiance.emplace_back(std::exp2(exponent(random)), std::exp2(exponent(random)),
                               std::exp2(exponent(random)));
  film.radiance[0] = vec3(0.0f);
  film.radiance[1] = vec3(std::numeric_limits<float>::infinity(), 0.2f, 0.0f);
  film.radiance[2] = vec3(std::numeric_limits<float>::quiet_NaN(), 0.3f, 0.1f);
  film.radiance[3] = vec3(-1.0f, 0.0f, 0.0f);
  return film;
}

TEST(AutomaticExposure, IsThatOfAllStopsInTheirOrder) {
  const Film film = varied_film(397, 211);
  std::vector<double> stops;
  for (const vec3& radiance : film.radiance) {
    const double light = luminance(dvec3(radiance));
    if (light > 1e-9 && std::isfinite(light)) stops.push_back(std::log2(light));
  }
  std::sort(stops.begin(), stops.end());
  const auto at = [&](double share) {
    return stops.begin() +
           static_cast<std::ptrdiff_t>(share * static_cast<double>(stops.size() - 1));
  };
  const double middle =
      std::accumulate(at(0.2), at(0.95), 0.0) / static_cast<double>(at(0.95) - at(0.2));
  // Lights of this brightness darken the whole picture by two stops.
  ASSERT_GT(*at(0.95) - middle, std::log2(1.5 / 0.21) + 2.0);
  EXPECT_NEAR(automatic_exposure_ev(film), std::log2(0.21) - middle - 2.0, 1e-11);
}

TEST(AutomaticExposure, DoesNotDependOnTheNumberOfThreads) {
  const Film film = varied_film(500, 400);
  const double ev = automatic_exposure_ev(film);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(automatic_exposure_ev(film), ev);
}

TEST(Develop, TakesRowsOfAnyLengthAndWhatIsNoColour) {
  for (const int width : {1, 5, 127, 129, 300}) {
    Film film = varied_film(width, 9);
    // A film contains no NaN, so this value is replaced.
    film.radiance[2] = vec3(0.5f);
    const Pixels pixels = develop(film, 0.0);
    for (int i = 0; i < width * 9; ++i) {
      const dvec3 display = tone_map(dvec3(film.radiance[static_cast<std::size_t>(i)]));
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(pixels.rgb[static_cast<std::size_t>(3 * i + c)],
                    quantise(srgb_from_linear(display[c]), i % width, i / width), 1)
            << "pixel " << i << " of " << width;
      }
    }
  }
}

TEST(Develop, RefusesAFilmWithoutItsPixels) {
  Film film;
  film.width = 4;
  film.height = 4;
  film.radiance.resize(15);
  EXPECT_THROW(develop(film, 0.0), Error);
}

TEST(Develop, FollowsTheCurvesThoughItReadsThemFromTables) {
  Film film;
  film.width = 512;
  film.height = 512;
  std::mt19937 random(41);
  std::uniform_real_distribution<float> exponent(-14.0f, 4.0f);
  for (int i = 0; i < film.width * film.height; ++i)
    film.radiance.emplace_back(std::exp2(exponent(random)), std::exp2(exponent(random)),
                               std::exp2(exponent(random)));
  const Pixels pixels = develop(film, 0.0);
  int different = 0;
  for (int i = 0; i < film.width * film.height; ++i) {
    const dvec3 display = tone_map(dvec3(film.radiance[static_cast<std::size_t>(i)]));
    for (int c = 0; c < 3; ++c) {
      const int expected = quantise(srgb_from_linear(display[c]), i % 512, i / 512);
      const int actual = pixels.rgb[static_cast<std::size_t>(3 * i + c)];
      ASSERT_LE(std::abs(actual - expected), 1);
      different += actual == expected ? 0 : 1;
    }
  }
  EXPECT_LT(different, 100) << "of 786432 values";
}

TEST(Develop, DithersAPartAsTheWhole) {
  // The light lies between two steps, so that the pattern of the dither is visible.
  std::vector<float> radiances(40 * 24);
  for (std::size_t i = 0; i < radiances.size(); ++i) {
    radiances[i] = 0.1f + 1e-5f * static_cast<float>(i);
  }
  Film film = grey_film(radiances);
  film.width = 40;
  film.height = 24;
  const Pixels all = develop(film, 0.0);
  for (const glm::ivec2 first : {glm::ivec2{5, 3}, glm::ivec2{8, 1}, glm::ivec2{39, 23}}) {
    Film part;
    part.width = 40 - first.x;
    part.height = 24 - first.y;
    part.first = first;
    part.whole = {40, 24};
    std::vector<std::uint8_t> expected;
    for (int y = first.y; y < 24; ++y) {
      for (int x = first.x; x < 40; ++x) {
        const auto at = static_cast<std::size_t>(y * 40 + x);
        part.radiance.push_back(film.radiance[at]);
        expected.insert(expected.end(), &all.rgb[3 * at], &all.rgb[3 * at] + 3);
      }
    }
    EXPECT_EQ(develop(part, 0.0).rgb, expected) << first.x << ", " << first.y;
  }
}

}  // namespace
}  // namespace aerostat::image
