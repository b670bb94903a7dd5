// Tests that kernels read a picture on the ground as the host does.
#include "land/drape.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "geo/transform.hpp"
#include "pack/pack_scene.hpp"
#include "probe.hpp"
#include "support/drape_files.hpp"

namespace aerostat::test {
namespace {

constexpr const char* kUtm = "EPSG:32632";
constexpr std::size_t kPoints = 4096;
constexpr std::uint32_t kFirst = 1000;  // words of other pictures lie before the drape's

class DrapeOnDevice : public LaneTest {
 protected:
  DrapeOnDevice() : drape_(options(folder_)), numbers_(pack::pack_drape(drape_, 1.0, kFirst)) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> share(-1.0f, 1.0f), level(-3.0f, 9.0f),
        reach(5.0f, 14.5f);
    for (std::size_t i = 0; i < kPoints; ++i) {
      const float wide = std::exp2(reach(random));
      places_.emplace_back(wide * share(random), 700.0f, wide * share(random));
      footprints_.push_back(std::exp2(level(random)));
    }
  }

  /// A picture of random colours and opacities, 600 x 500 pixels of 5 m.
  static land::DrapeOptions options(const DrapeFolder& folder) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> byte(0, 255);
    const auto any = [&](int, int) {
      return std::array{byte(random), byte(random), byte(random), byte(random)};
    };
    land::DrapeOptions options;
    options.file = folder.write_png("a.png", 600, 500, any, 499000.0, 5201000.0, 5.0);
    options.picture.crs = kUtm;
    options.middle.place = geo::place_of(kUtm, {500000.0, 5200000.0});
    options.reach_m = 15000.0;
    return options;
  }

  std::vector<float> run(const char* kernel, std::size_t planes_count) const {
    const std::size_t count = whole_packets(kPoints);
    const auto found = output<float>(planes_count * count);
    std::vector<std::uint32_t> texels(kFirst, 0xFF00FFFFu);
    texels.insert(texels.end(), drape_.texels().begin(), drape_.texels().end());
    Probe{"drape.cl", GetParam()}.run(kernel, count, input(std::vector<AeroDrape>{numbers_}),
                                      input(texels), input(planes(places_)),
                                      input(padded(footprints_)), found);
    return found.read();
  }

  DrapeFolder folder_;
  land::Drape drape_;
  AeroDrape numbers_;
  std::vector<vec3> places_;
  std::vector<float> footprints_;
};

// Places are rounded to a few millionths of 15 km in single precision, which is a hundredth of a
// texel of 5 m.
TEST_P(DrapeOnDevice, IsWhatTheHostSees) {
  const auto found = run("probe_drape", 4);
  const std::size_t count = whole_packets(kPoints);
  int covered = 0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const land::vec4 expected = drape_.at(places_[i].x, places_[i].z, footprints_[i]);
    covered += expected.w > 0.0f ? 1 : 0;
    for (std::size_t k = 0; k < 4; ++k) {
      ASSERT_NEAR(found[k * count + i], expected[static_cast<int>(k)], 0.01f)
          << i << " at " << places_[i].x << ", " << places_[i].z << ", " << footprints_[i] << " m";
    }
  }
  EXPECT_GT(covered, 1000);
  EXPECT_LT(covered, 3800);
}

TEST_P(DrapeOnDevice, CoversTheGroundByItsOpacityAndBlend) {
  numbers_.blend = 0.5f;
  const auto albedo = run("probe_draped_ground", 3);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const land::vec4 seen = drape_.at(places_[i].x, places_[i].z, footprints_[i]);
    ASSERT_NEAR(from_planes(albedo, i).x, 0.5f * (1.0f - 0.5f * seen.w) + 0.5f * seen.x, 0.01f);
  }
}

AEROSTAT_AT_EVERY_WIDTH(DrapeOnDevice);

}  // namespace
}  // namespace aerostat::test
