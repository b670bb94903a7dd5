// Compares the pictures of all scenes with those that somebody last looked at.
// AEROSTAT_UPDATE_GOLDENS=1 renews the files in tests/image/golden. Look at them before they are
// kept.
//
// The tolerance, in steps of 1/255 after development, is a mean of 0.3 and 4 for 99 of 100 values.
// The widths of packets differ by 1e-7 of the radiance, so other devices change a few values of the
// dither and a few samples at edges. A visible change of colour, light or shape is larger.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "compare_pixels.hpp"
#include "small_films.hpp"

namespace aerostat::test {
namespace {

namespace fs = std::filesystem;

constexpr double kMeanSteps = 0.3;
constexpr int kPercentileSteps = 4;

bool within_tolerance(const PixelDifference& d) {
  return d.mean <= kMeanSteps && d.percentile_99 <= kPercentileSteps;
}

std::string in_words(const PixelDifference& d) {
  char text[96];
  std::snprintf(text, sizeof(text), "mean %.3f, 99th percentile %d, largest %d steps of 1/255",
                d.mean, d.percentile_99, d.largest);
  return text;
}

bool renewing() {
  const char* value = std::getenv("AEROSTAT_UPDATE_GOLDENS");
  return value != nullptr && std::string(value) == "1";
}

/// Returns whether `actual` is the golden picture `name`. If it is not, writes both pictures and
/// their difference.
testing::AssertionResult is_golden(const image::Pixels& actual, const std::string& name) {
  const fs::path golden_file = fs::path(AEROSTAT_GOLDEN_DIR) / (name + ".png");
  const fs::path report = fs::path(AEROSTAT_GOLDEN_REPORT_DIR);
  const fs::path actual_file = report / (name + "-actual.png");
  const auto golden = read_png(golden_file);
  if (!golden || golden->width != actual.width || golden->height != actual.height) {
    write_png(actual_file, actual);
    return testing::AssertionFailure()
           << golden_file << (golden ? " has another size" : " is missing")
           << "; actual: " << actual_file
           << ". Look at it; AEROSTAT_UPDATE_GOLDENS=1 makes it the golden one.";
  }
  const PixelDifference d = difference(*golden, actual);
  const fs::path difference_file = report / (name + "-difference.png");
  if (within_tolerance(d)) {
    fs::remove(actual_file);
    fs::remove(difference_file);
    return testing::AssertionSuccess() << in_words(d);
  }
  write_png(actual_file, actual);
  write_png(difference_file, difference_picture(*golden, actual));
  return testing::AssertionFailure()
         << in_words(d) << "\n  golden:     " << golden_file << "\n  actual:     " << actual_file
         << "\n  difference: " << difference_file << " (8 times as bright)";
}

image::Pixels developed(const std::string& name) {
  const image::Film& film = small_film(name);
  return image::develop(film, image::automatic_exposure_ev(film));
}

void expect_golden(const image::Pixels& actual, const std::string& name) {
  if (renewing()) {
    write_png(fs::path(AEROSTAT_GOLDEN_DIR) / (name + ".png"), actual);
    std::printf("renewed the golden picture of %s\n", name.c_str());
  }
  EXPECT_TRUE(is_golden(actual, name));
}

class Golden : public testing::TestWithParam<const char*> {};

TEST_P(Golden, LooksAsItDid) {
  expect_golden(developed(GetParam()), GetParam());
}

constexpr int kTile = 8;

/// Returns a picture with one pixel for each tile of 8 x 8 pixels. Its upper half holds their
/// means. Its lower half holds eight times the mean difference of neighbours in a row, which tells
/// how much detail a tile shows.
image::Pixels tiles_of(const image::Pixels& picture) {
  const int width = picture.width / kTile, height = picture.height / kTile;
  image::Pixels tiles{width, 2 * height,
                      std::vector<std::uint8_t>(static_cast<std::size_t>(6 * width * height))};
  const auto value = [&](int x, int y, int c) {
    return static_cast<int>(picture.rgb[static_cast<std::size_t>(3 * (y * picture.width + x) + c)]);
  };
  for (int i = 0; i < 3 * width * height; ++i) {
    const int x0 = i / 3 % width * kTile, y0 = i / 3 / width * kTile, c = i % 3;
    int sum = 0, detail = 0;
    for (int k = 0; k < kTile * kTile; ++k) {
      const int x = x0 + k % kTile, y = y0 + k / kTile;
      sum += value(x, y, c);
      detail += x > x0 ? std::abs(value(x, y, c) - value(x - 1, y, c)) : 0;
    }
    const auto at = static_cast<std::size_t>(i),
               half = static_cast<std::size_t>(3 * width * height);
    tiles.rgb[at] = static_cast<std::uint8_t>(sum / (kTile * kTile));
    tiles.rgb[half + at] = static_cast<std::uint8_t>(std::min(255, detail * 8 / (7 * kTile)));
  }
  return tiles;
}

// What is finer than a pixel is filtered, and models are as fine as they are large in the picture.
// In the small pictures nearly all of that is gone.
TEST(Golden, LooksAsItDidInALargerPicture) {
  const image::Film film =
      shared_session().render(resolved(planted_scene("tropical", {480, 320, 4, 512})));
  expect_golden(tiles_of(image::develop(film, image::automatic_exposure_ev(film))),
                "tropical-large");
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(kScenes), scene_test_name);

/// The names of the scenes that no other test renders.
constexpr std::array<const char*, 16> kShownScenes = {
    "valley-fog", "alpenglow", "night-glow",   "storm",    "autumn", "lake",  "canyon",  "festival",
    "raetikon",   "st-helens", "grand-canyon", "swallows", "flight", "whale", "descent", "launch"};

INSTANTIATE_TEST_SUITE_P(ShownScenes, Golden, testing::ValuesIn(kShownScenes), scene_test_name);

TEST(GoldenTolerance, LetsNoChangedColourPass) {
  const scene::Scene usual = planted_scene("snow", kGoldenSize);
  const image::Pixels expected = developed("snow");
  // The exposure is that of the golden picture, because an automatic exposure would hide a part of
  // a change.
  const double exposure_ev = image::automatic_exposure_ev(small_film("snow"));
  const auto off = [&](const scene::Scene& scene) {
    return difference(expected,
                      image::develop(shared_session().render(resolved(scene)), exposure_ev));
  };
  const PixelDifference none = off(usual);
  EXPECT_TRUE(within_tolerance(none)) << "the scene itself: " << in_words(none);
  auto scene = usual;
  const auto changed = [&](const char* what) {
    const PixelDifference d = off(scene);
    EXPECT_FALSE(within_tolerance(d)) << what << ": " << in_words(d);
    scene = usual;
  };
  scene.balloon.colors[0] = vec3(0.1f, 0.1f, 0.6f);
  changed("one colour of the envelope");
  scene.biome.ground.snow *= 0.8f;
  changed("the snow a fifth darker");
  scene.air.density *= 1.25;
  changed("the air a quarter denser");
  scene.haze.visibility_m *= 0.8;
  changed("the view a fifth shorter");
  scene.sun.irradiance *= 0.9;
  changed("the sun a tenth dimmer");
  scene.camera.fov_y_deg *= 1.03;
  changed("the view three per cent wider");
}

TEST(GoldenTolerance, MissesNoPictureThatIsNotThere) {
  const image::Pixels actual = developed("snow");
  const auto result = is_golden(actual, "no-such-scene");
  EXPECT_FALSE(result);
  EXPECT_NE(std::string(result.message()).find("is missing"), std::string::npos);
  const fs::path written = fs::path(AEROSTAT_GOLDEN_REPORT_DIR) / "no-such-scene-actual.png";
  const auto kept = read_png(written);
  ASSERT_TRUE(kept.has_value()) << written;
  EXPECT_EQ(kept->rgb, actual.rgb);
  fs::remove(written);
}

}  // namespace
}  // namespace aerostat::test
