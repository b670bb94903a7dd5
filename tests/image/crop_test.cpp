// Tests that a part of a picture is exactly what the whole picture shows there.
#include <algorithm>

#include "image/write.hpp"
#include "pictures.hpp"
#include "render/development.hpp"
#include "render/metering.hpp"
#include "render/passes.hpp"

namespace aerostat::test {
namespace {

using render::Crop;
using render::PassPlan;
using render::Session;

constexpr int kWidth = 61, kHeight = 43;

// The crops are two corners, the middle, a row, one pixel, and odd sizes.
constexpr std::array kCrops = {Crop{0, 0, 9, 7}, Crop{50, 30, 61, 43}, Crop{20, 15, 41, 28},
                               Crop{0, 21, 61, 22}, Crop{33, 17, 34, 18}};

scene::Scene scene_of(scene::Quality quality) {
  scene::Scene scene = small_scene("snow", {kWidth, kHeight, 1, 128});
  scene::set_quality(scene, quality);
  // This many samples let some decisions about convergence be made, in less time than the quality's
  // own number.
  scene.image.spp = std::min(scene.image.spp, 80);
  scene.image.vignette = 0.4;
  return scene;
}

image::Pixels developed(const scene::Scene& scene, const image::Film& film) {
  return image::develop(film, render::development_of(scene.image, film));
}

std::vector<std::uint8_t> cut_bytes(const image::Pixels& pixels, const Crop& crop) {
  std::vector<std::uint8_t> part;
  for (int y = crop.y0; y < crop.y1; ++y) {
    const auto row = pixels.rgb.begin() + static_cast<std::ptrdiff_t>(3 * y) * pixels.width;
    part.insert(part.end(), row + 3 * crop.x0, row + 3 * crop.x1);
  }
  return part;
}

std::string text_of(const Crop& crop) {
  const auto text = [](int value) { return std::to_string(value); };
  return "crop " + text(crop.x0) + "," + text(crop.y0) + "," + text(crop.x1) + "," + text(crop.y1);
}

class CropAt : public testing::TestWithParam<scene::Quality> {
 protected:
  CropAt() : scene_(scene_of(GetParam())), whole_(shared_session().render(resolved(scene_))) {}

  void expect_the_same(Session& session, const Crop& crop) const {
    const image::Film film = session.render(resolved(scene_), {}, {}, crop);
    EXPECT_TRUE(same_bits(cut(whole_, crop), film)) << text_of(crop);
    EXPECT_TRUE(developed(scene_, film).rgb == cut_bytes(developed(scene_, whole_), crop))
        << text_of(crop);
    EXPECT_EQ(film.metered_ev, whole_.metered_ev) << text_of(crop);
    EXPECT_EQ(film.first, (glm::ivec2{crop.x0, crop.y0}));
    EXPECT_EQ(film.whole, (glm::ivec2{kWidth, kHeight}));
  }

  scene::Scene scene_;
  image::Film whole_;
};

TEST_P(CropAt, IsThatPartOfTheWhole) {
  for (const Crop& crop : kCrops) expect_the_same(shared_session(), crop);
}

TEST_P(CropAt, IsThatPartInTilesAndOnSeveralDevices) {
  render::Options options = test::options();
  options.tile_pixels = 100;
  options.devices = opencl::select_devices("cpu/2");
  Session session(options);
  expect_the_same(session, kCrops[2]);
  EXPECT_TRUE(same_bits(cut(whole_, kCrops[2]), session.snapshot()));
}

TEST_P(CropAt, BesideOthersMakesTheWhole) {
  const image::Pixels expected = developed(scene_, whole_);
  image::Pixels stitched{kWidth, kHeight, std::vector<std::uint8_t>(expected.rgb.size())};
  constexpr int kColumn = 23, kRow = 15;
  for (int y0 = 0; y0 < kHeight; y0 += kRow) {
    for (int x0 = 0; x0 < kWidth; x0 += kColumn) {
      const Crop crop{x0, y0, std::min(x0 + kColumn, kWidth), std::min(y0 + kRow, kHeight)};
      const image::Pixels part =
          developed(scene_, shared_session().render(resolved(scene_), {}, {}, crop));
      for (int y = 0; y < part.height; ++y) {
        const auto row = part.rgb.begin() + static_cast<std::ptrdiff_t>(3 * y) * part.width;
        std::copy_n(row, 3 * part.width,
                    stitched.rgb.begin() + 3 * ((y0 + y) * std::ptrdiff_t{kWidth} + x0));
      }
    }
  }
  EXPECT_TRUE(stitched.rgb == expected.rgb);
}

std::string name_of(const testing::TestParamInfo<scene::Quality>& quality) {
  constexpr std::array kNames = {"Draft", "Standard", "Final"};
  return kNames[static_cast<std::size_t>(quality.param)];
}

INSTANTIATE_TEST_SUITE_P(Qualities, CropAt,
                         testing::Values(scene::Quality::draft, scene::Quality::standard,
                                         scene::Quality::final),
                         name_of);

TEST(CropAtFinal, HoldsPixelsThatTheirNeighboursDecide) {
  // The tests above need both pixels that converge early and pixels that do not.
  const image::Film film = shared_session().render(resolved(scene_of(scene::Quality::final)));
  EXPECT_TRUE(std::count(film.samples.begin(), film.samples.end(), 16u) > 100);
  EXPECT_TRUE(std::count(film.samples.begin(), film.samples.end(), 80u) > 100);
}

TEST(Metering, OfASmallDraftTakesNoRaysOfItsOwn) {
  scene::Scene scene = scene_of(scene::Quality::draft);
  const double filtered = shared_session().render(resolved(scene)).metered_ev;
  scene.image.filter = scene::Filter::box;
  const image::Film film = shared_session().render(resolved(scene));
  EXPECT_EQ(film.metered_ev, image::automatic_exposure_ev(film));
  EXPECT_EQ(film.metered_ev, filtered) << "metering sees no filter";
  EXPECT_EQ(shared_session().snapshot().metered_ev, film.metered_ev);
  EXPECT_EQ(shared_session().stats().metering_seconds, 0.0);
}

TEST(Metering, IsNearThatByAllPixels) {
  scene::Scene scene = planted_scene("tropical", {400, 225, 1, 128});
  const image::Film film = shared_session().render(resolved(scene));
  EXPECT_NEAR(film.metered_ev, image::automatic_exposure_ev(film), 0.02);
  EXPECT_NE(film.metered_ev, image::automatic_exposure_ev(film)) << "by fewer rays";
  EXPECT_EQ(shared_session().snapshot().metered_ev, film.metered_ev);
}

TEST(Metering, IsLeftOutWhereTheExposureIsGiven) {
  scene::Scene scene = scene_of(scene::Quality::draft);
  scene.image.exposure_ev = 0.0;
  EXPECT_EQ(shared_session().render(resolved(scene)).metered_ev, 0.0);
  EXPECT_EQ(shared_session().stats().metering_seconds, 0.0);
}

TEST(Metering, IsLeftOutWhereNobodyDevelopsTheFilm) {
  render::Options options = test::options();
  options.contents = render::Contents::layers;
  render::Session session(std::move(options));
  EXPECT_EQ(session.render(resolved(scene_of(scene::Quality::draft))).metered_ev, 0.0);
  EXPECT_EQ(session.stats().metering_seconds, 0.0);
}

AeroFrame frame_of(std::uint32_t width, std::uint32_t height) {
  AeroFrame frame{};
  frame.width = width;
  frame.height = height;
  frame.camera.step_x[0] = frame.camera.step_y[1] = 1.0f;
  frame.samples = 256;
  frame.sample_stride = 97;
  frame.progressive = 1;
  return frame;
}

TEST(Metering, CoversPicturesOfAnyShapeByFewRays) {
  using Sides = std::array<std::uint32_t, 2>;
  const std::array<std::array<Sides, 2>, 6> cases = {{{Sides{1280, 720}, {160, 90}},
                                                      {Sides{30000, 30000}, {120, 120}},
                                                      {Sides{100, 50}, {100, 50}},
                                                      {Sides{1, 1}, {1, 1}},
                                                      {Sides{32768, 1}, {14400, 1}},
                                                      {Sides{1, 32768}, {1, 14400}}}};
  for (const auto& [picture, expected] : cases) {
    const AeroFrame metering = render::metering_frame(frame_of(picture[0], picture[1]));
    EXPECT_EQ((Sides{metering.width, metering.height}), expected);
    EXPECT_LE(metering.width * metering.height, render::kMeteringPixels);
    const double across = double{metering.camera.step_x[0]} * metering.width;
    const double down = double{metering.camera.step_y[1]} * metering.height;
    EXPECT_NEAR(across, picture[0], 1e-6 * picture[0]);
    EXPECT_NEAR(down, picture[1], 1e-6 * picture[1]);
    EXPECT_EQ(metering.samples, render::kMeteringSamples);
    EXPECT_LE(metering.sample_spread * metering.camera.step_x[0], 1.0f) << "within a pixel";
  }
}

TEST(Crop, TakesTheMemoryOfItself) {
  scene::Scene scene = scene_of(scene::Quality::draft);
  scene.image.width = scene.image.height = 32768;
  Session session(options());
  const image::Film film =
      session.render(resolved(scene), {}, {}, Crop{32704, 32732, 32768, 32768});
  EXPECT_EQ(film.width, 64);
  EXPECT_LT(session.stats().device_bytes, 200u << 20) << "the whole film alone has 52 GiB";
}

scene::Image image_of(int samples, double threshold) {
  scene::Image image;
  image.width = 200;
  image.height = 100;
  image.spp = samples;
  image.adaptive_threshold = threshold;
  image.filter = scene::Filter::box;
  return image;
}

std::array<int, 4> sides(const Crop& crop) {
  return {crop.x0, crop.y0, crop.x1, crop.y1};
}

TEST(PassPlan, HasNoApronWhereNothingIsDecided) {
  const Crop crop{50, 40, 60, 50};
  for (const auto& image : {image_of(256, 0.0), image_of(16, 0.01)}) {
    const PassPlan plan(image, crop, 16);
    EXPECT_EQ(sides(plan.area_from(0)), sides(crop));
    EXPECT_EQ(plan.rays(), 100u * static_cast<unsigned>(image.spp));
  }
}

TEST(PassPlan, ShrinksTheApronWithEveryDecision) {
  const PassPlan plan(image_of(50, 0.01), {50, 1, 60, 50}, 16);
  EXPECT_EQ(sides(plan.area_from(0)), (std::array{47, 0, 63, 53}));
  EXPECT_EQ(sides(plan.area_from(15)), (std::array{47, 0, 63, 53}));
  EXPECT_EQ(sides(plan.area_from(16)), (std::array{48, 0, 62, 52}));
  EXPECT_EQ(sides(plan.area_from(32)), (std::array{49, 0, 61, 51}));
  EXPECT_EQ(sides(plan.area_from(48)), (std::array{50, 1, 60, 50}));
  EXPECT_EQ(plan.rays(), 16u * 16 * 53 + 16u * 14 * 52 + 16u * 12 * 51 + 2u * 10 * 49);
}

TEST(PassPlan, HasAnApronForTheFilterInEveryPass) {
  scene::Image still = image_of(4, 0.0), adaptive = image_of(50, 0.01);
  still.filter = adaptive.filter = scene::Filter::tent;
  const Crop crop{50, 0, 60, 50};
  EXPECT_EQ(sides(PassPlan(still, crop, 16).area_from(0)), (std::array{49, 0, 61, 51}));
  EXPECT_EQ(sides(PassPlan(adaptive, crop, 16).area_from(0)), (std::array{46, 0, 64, 54}));
  EXPECT_EQ(sides(PassPlan(adaptive, crop, 16).area_from(48)), (std::array{49, 0, 61, 51}));
  EXPECT_EQ(sides(PassPlan(still, crop, 16, false).area_from(0)), sides(crop));
}

TEST(PassPlan, IsOfAllSamplesInPassesThatEndWithARound) {
  const PassPlan plan(image_of(50, 0.01), {50, 1, 60, 50}, 8);
  std::vector<int> begins, decisions;
  for (int done = 0; done < 50; done += plan.samples_from(done)) {
    begins.push_back(done);
    if (plan.decides_before(done)) decisions.push_back(done);
  }
  EXPECT_EQ(begins, (std::vector{0, 1, 9, 13, 15, 16, 24, 32, 40, 48}));
  EXPECT_EQ(decisions, (std::vector{16, 32, 48}));
}

}  // namespace
}  // namespace aerostat::test
