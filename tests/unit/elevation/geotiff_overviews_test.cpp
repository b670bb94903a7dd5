// Reduced versions in GeoTIFF files.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <tiffio.h>

#include "elevation/open.hpp"
#include "files.hpp"
#include "tiff_files.hpp"

namespace aerostat::elevation {
namespace {

TiffPageSpec reduced(int factor) {
  TiffPageSpec page;
  page.width = (page.width + factor - 1) / factor;
  page.height = (page.height + factor - 1) / factor;
  page.subfile = FILETYPE_REDUCEDIMAGE;
  page.tile = 16;
  page.value = [factor](int i, int j) { return 1000.0 * factor + i + j; };
  return page;
}

void expect_overviews(const Raster& raster) {
  ASSERT_EQ(raster.overview_factors().size(), 2u);
  EXPECT_NEAR(raster.overview_factors()[0], 37.0 / 19.0, 1e-9);
  EXPECT_NEAR(raster.overview_factors()[1], 37.0 / 10.0, 1e-9);
  EXPECT_EQ(raster.overview_size(0), (std::array<int, 2>{19, 15}));
  EXPECT_EQ(raster.overview_size(1), (std::array<int, 2>{10, 8}));
  std::vector<float> heights(4);
  raster.read_overview(0, {17, 13, 2, 2}, heights.data());
  EXPECT_EQ(heights, (std::vector<float>{2030.0f, 2031.0f, 2031.0f, 2032.0f}));
  raster.read_overview(1, {0, 0, 2, 2}, heights.data());
  EXPECT_EQ(heights, (std::vector<float>{4000.0f, 4001.0f, 4001.0f, 4002.0f}));
  raster.read({35, 27, 2, 2}, heights.data());
  EXPECT_EQ(heights, (std::vector<float>{159.0f, 162.0f, 161.0f, 164.0f}));
}

TEST(GeoTiffOverviews, AreDirectoriesOfTheirOwn) {
  const Folder folder;
  TiffPageSpec page, other;
  other.width = other.height = 5;  // of no size that belongs to the first one
  other.subfile = FILETYPE_REDUCEDIMAGE;
  other.bits = 16;
  write_tiff(folder.path() / "a.tif", {page, reduced(4), reduced(2), other});
  expect_overviews(*open(folder.path() / "a.tif"));
}

TEST(GeoTiffOverviews, AreSubdirectories) {
  const Folder folder;
  TiffPageSpec page;
  page.subfiles = 2;
  write_tiff(folder.path() / "a.tif", {page, reduced(2), reduced(4)});
  expect_overviews(*open(folder.path() / "a.tif"));
}

TEST(GeoTiffOverviews, HaveMasksOfTheirOwn) {
  const Folder folder;
  TiffPageSpec page, mask, small_mask = reduced(2);
  mask.bits = small_mask.bits = 1;
  mask.format = small_mask.format = 1;
  mask.photometric = small_mask.photometric = PHOTOMETRIC_MASK;
  mask.subfile = FILETYPE_MASK;
  small_mask.subfile = FILETYPE_MASK | FILETYPE_REDUCEDIMAGE;
  mask.value = [](int, int) { return 1.0; };
  small_mask.value = [](int i, int) { return i == 0 ? 0.0 : 1.0; };
  write_tiff(folder.path() / "a.tif", {page, mask, reduced(2), small_mask});
  const auto raster = open(folder.path() / "a.tif");
  ASSERT_EQ(raster->overview_factors().size(), 1u);
  std::vector<float> heights(2);
  raster->read_overview(0, {0, 0, 2, 1}, heights.data());
  EXPECT_TRUE(std::isnan(heights[0]));
  EXPECT_EQ(heights[1], 2001.0f);
  EXPECT_FALSE(std::isnan(height_at(*raster, 0, 0)));
}

}  // namespace
}  // namespace aerostat::elevation
