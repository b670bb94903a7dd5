// Tests that samples are taken where noise is, and that they are the same for all tiles, devices
// and widths of packets.
#include <cmath>
#include <cstdio>
#include <numeric>

#include "image/tone.hpp"
#include "pictures.hpp"

namespace aerostat::test {
namespace {

constexpr Size kSize = {64, 48, 64, 128};

scene::Scene adaptive_scene(double threshold) {
  scene::Scene scene = planted_scene("snow", kSize);
  scene.image.adaptive_threshold = threshold;
  return scene;
}

std::uint64_t samples_of(const image::Film& film) {
  return std::accumulate(film.samples.begin(), film.samples.end(), std::uint64_t{0});
}

TEST(Adaptive, WithoutAThresholdAllPixelsGetAllSamples) {
  const image::Film film = shared_session().render(resolved(adaptive_scene(0.0)));
  for (const auto samples : film.samples) ASSERT_EQ(samples, 64u);
}

TEST(Adaptive, MarksPixelsInWholeRounds) {
  const image::Film film = shared_session().render(resolved(adaptive_scene(0.01)));
  std::uint64_t least = 0, most = 0;
  for (std::size_t i = 0; i < film.samples.size(); ++i) {
    ASSERT_EQ(film.samples[i] % 16u, 0u) << "pixel " << i;
    ASSERT_LE(film.samples[i], 64u);
    least += film.samples[i] == 16u ? 1 : 0;
    most += film.samples[i] == 64u ? 1 : 0;
  }
  EXPECT_GT(least, film.samples.size() / 4);
  EXPECT_GT(most, film.samples.size() / 50);
  EXPECT_EQ(shared_session().stats().rays[render::KernelStage::primary], samples_of(film));
}

TEST(Adaptive, TakesFewerSamplesForMoreNoise) {
  std::uint64_t before = 64u * 64u * 48u + 1u;
  for (const double threshold : {1e-6, 0.003, 0.02, 1.0}) {
    const std::uint64_t samples =
        samples_of(shared_session().render(resolved(adaptive_scene(threshold))));
    EXPECT_LT(samples, before) << threshold;
    before = samples;
  }
  EXPECT_EQ(before, 16u * 64u * 48u) << "nothing is noisier than white beside black";
}

/// Tests that the picture is nearly that of all samples, because few samples are taken only where
/// few suffice.
TEST(Adaptive, IsNearThePictureOfAllSamples) {
  const image::Film film = shared_session().render(resolved(adaptive_scene(0.01)));
  const image::Film all = shared_session().render(resolved(adaptive_scene(1e-9)));
  double square = 0.0, light = 0.0;
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    const double off = static_cast<double>(film.radiance[i].y - all.radiance[i].y);
    square += off * off / static_cast<double>(film.radiance.size());
    light += static_cast<double>(all.radiance[i].y) / static_cast<double>(film.radiance.size());
  }
  EXPECT_GT(square, 0.0) << "some pixels took fewer";
  EXPECT_LT(std::sqrt(square), 0.03 * light);
}

std::vector<double> light_of(const image::Film& film) {
  std::vector<double> light;
  for (const vec3& radiance : film.radiance) light.push_back(image::luminance(dvec3(radiance)));
  return light;
}

/// Pictures of all samples, and of as many as the threshold asks for, for several seeds.
struct Seeds {
  static constexpr int kCount = 16;
  static constexpr double kThreshold = 0.01;

  Seeds() {
    scene::Scene scene = planted_scene("snow", {24, 16, 64, 128});
    for (int seed = 1; seed <= kCount; ++seed) {
      scene.image.seed = static_cast<std::uint32_t>(seed);
      scene.image.adaptive_threshold = 1e-9;
      all.push_back(light_of(shared_session().render(resolved(scene))));
      scene.image.adaptive_threshold = kThreshold;
      film = shared_session().render(resolved(scene));
      fewer.push_back(light_of(film));
      samples.push_back(film.samples);
    }
    truth.resize(all[0].size());
    for (const auto& light : all) {
      for (std::size_t i = 0; i < truth.size(); ++i) truth[i] += light[i] / kCount;
    }
  }

  std::vector<std::vector<double>> all, fewer;
  std::vector<Array<std::uint32_t>> samples;
  std::vector<double> truth;  // the means over the seeds
  image::Film film;           // the last one
};

const Seeds& seeds() {
  static const Seeds made;
  return made;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Tests the known fault of stopping by what was seen: pixels that have missed what is rare and
/// bright stop, and the picture becomes darker. What is lost on average over some seeds is less
/// than a twentieth of a step of a display.
TEST(Adaptive, LosesNoLight) {
  const double light = mean_of(seeds().truth);
  double lost = 0.0, square = 0.0;
  for (int seed = 0; seed < Seeds::kCount; ++seed) {
    const double less = mean_of(seeds().all[seed]) - mean_of(seeds().fewer[seed]);
    lost += less / Seeds::kCount;
    square += less * less / Seeds::kCount;
  }
  const double error = std::sqrt((square - lost * lost) / (Seeds::kCount - 1));
  std::printf("%.4f %% of the light is lost, with a standard error of %.4f %%\n",
              100.0 * lost / light, 100.0 * error / light);
  EXPECT_LT(std::abs(lost), 4e-4 * light);
  EXPECT_LT(error, 1.5e-4 * light) << "too few seeds to tell";
}

/// Tests that pixels with fewer samples have no more noise than the threshold allows. It is
/// measured on the square root of the light, as a display shows it, where light below a fiftieth of
/// white counts as dark. It is a quarter of that, because samples are spread evenly and pixels wait
/// for their neighbours.
TEST(Adaptive, LeavesTheNoiseThatIsAllowed) {
  const double white = image::luminance(dvec3(seeds().film.daylight));
  double ratio = 0.0, count = 0.0;
  for (int seed = 0; seed < Seeds::kCount; ++seed) {
    for (std::size_t i = 0; i < seeds().truth.size(); ++i) {
      if (seeds().samples[seed][i] == 64u) continue;
      const double off = seeds().fewer[seed][i] - seeds().truth[i];
      const double allowed =
          4.0 * Seeds::kThreshold * Seeds::kThreshold * white * (seeds().truth[i] + 0.02 * white);
      ratio += off * off / allowed;
      count += 1.0;
    }
  }
  std::printf("%.0f pixels took fewer samples, with %.3f times the noise allowed\n", count,
              std::sqrt(ratio / count));
  EXPECT_GT(count, 1000.0);
  EXPECT_LT(std::sqrt(ratio / count), 0.3);
}

TEST(Adaptive, DependsOnNoTileOrDevice) {
  const scene::Scene scene = adaptive_scene(0.006);
  const image::Film expected = shared_session().render(resolved(scene));
  const auto same = [&](const image::Film& film, const image::Film& other) {
    EXPECT_TRUE(same_bits(film, other));
    EXPECT_EQ(film.samples, other.samples);
  };
  render::Options options = test::options();
  options.tile_pixels = 333;
  render::Session tiled(options);
  same(expected, tiled.render(resolved(scene)));
  options.tile_pixels = 0;
  options.devices = opencl::select_devices("Portable Computing Language/2");
  render::Session halves(options);
  same(expected, halves.render(resolved(scene)));
}

TEST(Adaptive, TakesTheSameSamplesAtAnotherWidth) {
  const scene::Scene scene = adaptive_scene(0.006);
  const image::Film expected = shared_session().render(resolved(scene));
  render::Session narrow(options(4));
  const image::Film film = narrow.render(resolved(scene));
  int different = 0;
  for (std::size_t i = 0; i < film.samples.size(); ++i) {
    different += film.samples[i] == expected.samples[i] ? 0 : 1;
  }
  // The last bit of a library function may decide whether a pixel converges.
  EXPECT_LE(different, static_cast<int>(film.samples.size()) / 200);
}

}  // namespace
}  // namespace aerostat::test
