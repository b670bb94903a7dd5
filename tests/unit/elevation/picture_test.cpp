#include "elevation/picture.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include <gtest/gtest.h>
#include <zlib.h>

#include "core/error.hpp"
#include "files.hpp"
#include "png_file.hpp"
#include "tiff_files.hpp"

namespace aerostat::elevation {
namespace {

namespace fs = std::filesystem;

/// A folder for one test.
class PictureTest : public ::testing::Test {
 protected:
  PictureTest()
      : folder_(fs::temp_directory_path() /
                (std::string("aerostat-picture-") +
                 ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(folder_);
  }
  ~PictureTest() override { fs::remove_all(folder_); }

  /// Returns a page of red, green and blue: red counts columns, and the others are `other`.
  static TiffPageSpec colours(int bits = 8) {
    TiffPageSpec page = page_at(32632, 500000.0, 5200000.0, 2.0);
    page.bits = bits;
    page.format = 1;
    page.bands = 3;
    page.photometric = 2;  // RGB
    page.value = [](int i, int) { return static_cast<double>(i); };
    page.other = [](int, int) { return 51.0; };
    return page;
  }

  std::unique_ptr<Picture> open(const std::vector<TiffPageSpec>& pages,
                                const PictureOptions& options = {}) const {
    const fs::path path = folder_ / "a.tif";
    write_tiff(path, pages);
    return open_picture(path, options);
  }

  static vec4 pixel(const Picture& picture, int column, int row, int level = 0) {
    vec4 found(-1.0f);
    picture.read(level, {column, row, 1, 1}, &found);
    return found;
  }

  static std::string error(const std::function<void()>& act) {
    try {
      act();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(PictureTest, AWindowHoldsItsPixels) {
  for (const int tile : {0, 16}) {
    for (const bool apart : {false, true}) {
      TiffPageSpec page = colours();
      page.tile = tile;
      page.bands_apart = apart;
      const auto picture = open({page});
      std::vector<vec4> found(20 * 15);
      picture->read(0, {9, 7, 20, 15}, found.data());
      for (int j = 0; j < 15; ++j) {
        for (int i = 0; i < 20; ++i) {
          const vec4& one = found[static_cast<std::size_t>(20 * j + i)];
          ASSERT_FLOAT_EQ(one.x, albedo_of_srgb((9 + i) / 255.0)) << i << ' ' << j;
          ASSERT_FLOAT_EQ(one.z, albedo_of_srgb(0.2));
          ASSERT_EQ(one.w, 1.0f);
        }
      }
    }
  }
}

TEST_F(PictureTest, SixteenBitsAreAShareOfWhite) {
  TiffPageSpec page = colours(16);
  page.other = [](int, int) { return 13107.0; };
  EXPECT_NEAR(pixel(*open({page}), 3, 3).y, albedo_of_srgb(0.2), 1e-6f);
}

TEST_F(PictureTest, OpacityIsKept) {
  TiffPageSpec page = colours();
  page.bands = 4;
  page.last_is_opacity = true;
  const vec4 found = pixel(*open({page}), 30, 2);
  EXPECT_NEAR(found.w, 0.2f, 1e-6f);
  EXPECT_LE(found.y, 0.2f * albedo_of_srgb(1.0));
}

TEST_F(PictureTest, AMaskHidesPixels) {
  TiffPageSpec mask = colours();
  mask.bits = 1;
  mask.bands = 1;
  mask.photometric = 4;
  mask.subfile = 4;
  mask.value = [](int i, int) { return i < 20 ? 1.0 : 0.0; };
  const auto picture = open({colours(), mask});
  EXPECT_EQ(pixel(*picture, 19, 5).w, 1.0f);
  EXPECT_EQ(pixel(*picture, 20, 5), vec4(0.0f));
}

TEST_F(PictureTest, NodataIsTransparent) {
  TiffPageSpec page = colours();
  page.nodata = "51";
  const auto picture = open({page});
  EXPECT_EQ(pixel(*picture, 5, 5).w, 1.0f) << "all bands have to be the value";
  page.value = page.other;
  EXPECT_EQ(pixel(*open({page}), 5, 5).w, 0.0f);
}

TEST_F(PictureTest, OverviewsAreLevels) {
  TiffPageSpec half = colours();
  half.width = 19;
  half.height = 15;
  half.subfile = 1;
  half.other = [](int, int) { return 102.0; };
  const auto picture = open({colours(), half});
  ASSERT_EQ(picture->levels().size(), 2u);
  EXPECT_FLOAT_EQ(pixel(*picture, 3, 3, 1).y, albedo_of_srgb(0.4));
}

TEST_F(PictureTest, APaletteGivesColours) {
  TiffPageSpec page = colours();
  page.bands = 1;
  page.photometric = 3;
  EXPECT_EQ(pixel(*open({page}), 7, 7), vec4(0.0f, 0.0f, 0.0f, 1.0f)) << "the palette is black";
}

TEST_F(PictureTest, OtherSamplesAreRefused) {
  TiffPageSpec page = colours();
  page.bits = 32;
  page.format = 3;
  EXPECT_NE(error([&] { open({page}); }).find("8 or 16 bits"), std::string::npos);
}

TEST_F(PictureTest, AWrongSystemIsNoticed) {
  EXPECT_NE(error([&] {
              open({colours()}, {"EPSG:4326", {}});
            }).find("/terrain/drape/crs"),
            std::string::npos);
}

TEST_F(PictureTest, ATiffWithoutAPlaceNamesTheOption) {
  TiffPageSpec page = colours();
  page.geo_keys = {};
  page.pixel_scale = page.tiepoints = {};
  EXPECT_NE(error([&] { open({page}); }).find("/terrain/drape/corners"), std::string::npos);
  PictureOptions options;
  options.corners = {geo::Place{47.0, 9.0}, geo::Place{46.0, 10.0}};
  const auto picture = open({page}, options);
  EXPECT_NEAR(picture->info().georeference->origin.x, 9.0 + 0.5 / 37.0, 1e-12);
}

TEST_F(PictureTest, AHugePngIsRefusedBeforeItIsDecoded) {
  std::string bytes = png(1, 1, 8, 2, {1, 2, 3});
  for (const std::size_t at : {16u, 20u}) bytes[at + 2] = 0x40;  // 16385 pixels a side
  // The checksum of the header holds its type and its 13 bytes.
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(bytes.data()) + 12, 17);
  for (unsigned i = 0; i < 4; ++i) bytes[29 + i] = static_cast<char>(sum >> (24 - 8 * i));
  const fs::path path = folder_ / "a.png";
  std::ofstream(path, std::ios::binary) << bytes;
  const std::string message = error([&] { open_picture(path, {}); });
  EXPECT_NE(message.find("16385 x 16385"), std::string::npos) << message;
}

TEST_F(PictureTest, AnyOtherFileIsRefused) {
  const fs::path path = folder_ / "a.txt";
  std::ofstream(path) << "no picture";
  EXPECT_NE(error([&] { open_picture(path, {}); }).find("no picture of a known format"),
            std::string::npos);
  std::ofstream(path).close();
  EXPECT_NE(error([&] { open_picture(path, {}); }).find("no picture of a known format"),
            std::string::npos);
  EXPECT_NE(
      error([&] { open_picture(folder_ / "b.png", {}); }).find("b.png: cannot read the picture"),
      std::string::npos);
}

}  // namespace
}  // namespace aerostat::elevation
