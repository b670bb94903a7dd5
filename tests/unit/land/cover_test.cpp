#include "land/cover.hpp"

#include <cstddef>
#include <fstream>
#include <iomanip>
#include <string>

#include <gtest/gtest.h>

#include "geo/transform.hpp"
#include "support/error_of.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::land {
namespace {

constexpr const char* kCrs = "EPSG:32632";
constexpr dvec2 kMiddle{500000.0, 5200000.0};

/// A raster of codes in cells of 30 m around kMiddle.
class CoverFile : public ::testing::Test {
 protected:
  /// Writes side x side codes. `code` has the column and row.
  template <class Code>
  CoverOptions write(int side, const Code& code) {
    CoverOptions options;
    options.file = folder_.path() / "cover.asc";
    std::ofstream file(options.file);
    file << std::setprecision(10) << "ncols " << side << "\nnrows " << side << "\nxllcorner "
         << kMiddle.x - 15.0 * side << "\nyllcorner " << kMiddle.y - 15.0 * side
         << "\ncellsize 30\nNODATA_value 255\n";
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) file << code(i, j) << ' ';
      file << '\n';
    }
    options.crs = kCrs;
    options.middle.place = geo::place_of(kCrs, kMiddle);
    options.reach_m = 15.0 * side;
    return options;
  }

  static float share_of(const CoverShares& shares, CoverClass is) {
    return shares[static_cast<std::size_t>(is)];
  }

  test::TemporaryFolder folder_;
};

TEST_F(CoverFile, HasTheClassesWhereTheyLie) {
  // Woods in the west and crops in the east of NLCD, and no data in the south.
  const Cover cover(write(80, [](int i, int j) { return j >= 60 ? 255 : i < 40 ? 42 : 82; }));
  EXPECT_FLOAT_EQ(share_of(cover.at(-600.0, -300.0, 30.0), CoverClass::woods), 1.0f);
  EXPECT_FLOAT_EQ(share_of(cover.at(600.0, -300.0, 30.0), CoverClass::crops), 1.0f);
  for (const float share : cover.at(0.0, 1000.0, 30.0)) EXPECT_EQ(share, 0.0f);
  EXPECT_FALSE(cover.has_water());
  ASSERT_EQ(cover.notes().size(), 1u);
}

TEST_F(CoverFile, NeverAveragesCodes) {
  // The mean of 42 and 82 would be 62, which is no code at all.
  const Cover cover(write(64, [](int i, int j) { return (i + j) % 2 == 0 ? 42 : 82; }));
  const CoverShares shares = cover.at(0.0, 0.0, 480.0);
  EXPECT_NEAR(share_of(shares, CoverClass::woods), 0.5f, 0.07f);
  EXPECT_NEAR(share_of(shares, CoverClass::crops), 0.5f, 0.07f);
  EXPECT_EQ(share_of(shares, CoverClass::wetland), 0.0f);
  EXPECT_EQ(share_of(shares, CoverClass::shrub), 0.0f);
}

TEST_F(CoverFile, KnowsWater) {
  const Cover cover(write(64, [](int i, int) { return i < 32 ? 10 : 80; }));
  ASSERT_TRUE(cover.has_water());
  EXPECT_EQ(cover.water_at(-500.0, 0.0, 30.0), 0.0f);
  EXPECT_EQ(cover.water_at(500.0, 0.0, 30.0), 1.0f);
  EXPECT_NEAR(cover.water_at(0.0, 0.0, 30.0), 0.5f, 0.1f);
  EXPECT_EQ(cover.water_at(5000.0, 0.0, 30.0), 0.0f);
}

TEST_F(CoverFile, OfAnotherPlaceIsRefused) {
  CoverOptions options = write(16, [](int, int) { return 10; });
  options.middle.place->latitude_deg += 1.0;
  const std::string text = test::error_of([&] { const Cover cover(options); }).what();
  EXPECT_NE(text.find("does not lie on the land"), std::string::npos) << text;
}

TEST_F(CoverFile, WithFractionsIsNoLandCover) {
  const CoverOptions options = write(16, [](int i, int) { return 10.0 + 0.5 * i; });
  const std::string text = test::error_of([&] { const Cover cover(options); }).what();
  EXPECT_NE(text.find("no code of land cover"), std::string::npos) << text;
}

TEST(CoverTexel, HoldsSharesIn15ths) {
  const CoverShares shares{1.0f / 15, 0.0f, 0.2f, 1.0f, 0.0f, 0.4f, 0.0f, 0.6f};
  const CoverShares again = shares_of_texel(packed_shares(shares));
  for (std::size_t k = 0; k < shares.size(); ++k) EXPECT_FLOAT_EQ(again[k], shares[k]);
}

}  // namespace
}  // namespace aerostat::land
