// Tests that kernels read land cover as the host does.
#include "land/cover.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iomanip>
#include <random>
#include <vector>

#include "geo/transform.hpp"
#include "ground/ground_rule.hpp"
#include "pack/pack_cover.hpp"
#include "probe.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::test {
namespace {

constexpr const char* kUtm = "EPSG:32632";
constexpr std::size_t kPoints = 4096;
constexpr std::uint32_t kFirst = 100;  // words of other pictures lie before those of the cover

class CoverOnDevice : public LaneTest {
 protected:
  CoverOnDevice()
      : cover_(options(folder_)),
        numbers_(pack::pack_cover(scene::defaults(scene::BiomeKind::meadow, scene::View::outside),
                                  cover_, kFirst)) {
    std::mt19937 random(13);
    std::uniform_real_distribution<float> share(-1.0f, 1.0f), level(-1.0f, 9.0f),
        reach(5.0f, 13.5f);
    for (std::size_t i = 0; i < kPoints; ++i) {
      const float wide = std::exp2(reach(random));
      places_.emplace_back(wide * share(random), 700.0f, wide * share(random));
      footprints_.push_back(std::exp2(level(random)));
      broad_.push_back(0.5f * share(random));
      fine_.push_back(0.5f * share(random));
    }
  }

  /// Random codes of ESA WorldCover, 300 x 250 cells of 30 m.
  static land::CoverOptions options(const TemporaryFolder& folder) {
    land::CoverOptions options;
    options.file = folder.path() / "cover.asc";
    std::ofstream file(options.file);
    file << std::setprecision(10) << "ncols 300\nnrows 250\nxllcorner 496000\nyllcorner 5196000\n"
         << "cellsize 30\n";
    std::mt19937 random(5);
    std::uniform_int_distribution<int> code(1, 9);
    for (int i = 0; i < 300 * 250; ++i) file << 10 * code(random) << ' ';
    options.crs = kUtm;
    options.middle.place = geo::place_of(kUtm, {500000.0, 5200000.0});
    options.reach_m = 8000.0;
    return options;
  }

  std::vector<std::uint32_t> texels() const {
    std::vector<std::uint32_t> words(kFirst, 0xFFFFFFFFu);
    const std::vector<std::uint32_t>& own = cover_.ground().texels;
    words.insert(words.end(), own.begin(), own.end());
    return words;
  }

  TemporaryFolder folder_;
  land::Cover cover_;
  AeroCover numbers_;
  std::vector<vec3> places_;
  std::vector<float> footprints_, broad_, fine_;
};

TEST_P(CoverOnDevice, IsWhatTheHostSees) {
  const std::size_t count = whole_packets(kPoints);
  std::vector<float> noises = padded(broad_);
  const std::vector<float> fine = padded(fine_);
  noises.insert(noises.end(), fine.begin(), fine.end());
  const auto found = output<float>(AERO_COVER_CLASSES * count);
  Probe{"cover.cl", GetParam()}.run("probe_cover", count, input(std::vector<AeroCover>{numbers_}),
                                    input(texels()), input(planes(places_)), input(noises),
                                    input(padded(footprints_)), found);
  const auto shares = found.read();
  int covered = 0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    ground::GroundNoise noise{};
    noise.broad = broad_[i];
    noise.fine = fine_[i];
    const double texel = cover_.ground().texel_m;
    const CoverShares expected =
        cover_.at(places_[i].x + texel * rules::cover_stray_x(&noise),
                  places_[i].z + texel * rules::cover_stray_z(&noise), footprints_[i]);
    float known = 0.0f;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      ASSERT_NEAR(shares[k * count + i], expected[k], 0.01f) << i << ", class " << k;
      known += expected[k];
    }
    covered += known > 0.5f ? 1 : 0;
  }
  EXPECT_GT(covered, 1000);
  EXPECT_LT(covered, 4000);
}

TEST_P(CoverOnDevice, HasTheColoursOfItsClasses) {
  const std::size_t count = whole_packets(kPoints);
  const auto found = output<float>(3 * count);
  Probe{"cover.cl", GetParam()}.run("probe_covered", count, input(std::vector<AeroCover>{numbers_}),
                                    input(texels()), input(planes(places_)), found);
  const auto albedo = found.read();
  for (std::size_t i = 0; i < kPoints; ++i) {
    const CoverShares shares = cover_.at(places_[i].x, places_[i].z, 1.0);
    float expected = 0.0f, known = 0.0f;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      expected += shares[k] * numbers_.colors[k][1];
      known += shares[k];
    }
    expected += 0.5f * std::max(1.0f - known, 0.0f);
    ASSERT_NEAR(from_planes(albedo, i).y, expected, 0.01f) << i;
  }
}

AEROSTAT_AT_EVERY_WIDTH(CoverOnDevice);

}  // namespace
}  // namespace aerostat::test
