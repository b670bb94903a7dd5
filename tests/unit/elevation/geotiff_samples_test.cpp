// Samples of GeoTIFF files: types, codecs, predictors, blocks, bands, voids, scales.
#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <tiffio.h>

#include "elevation/open.hpp"
#include "files.hpp"
#include "tiff_files.hpp"

namespace aerostat::elevation {
namespace {

/// Writes a page and reads it as a whole.
std::vector<float> through_file(const TiffPageSpec& page, const char* mode = "w",
                                const OpenOptions& options = {}) {
  const Folder folder;
  const std::filesystem::path path = folder.path() / "heights.tif";
  write_tiff(path, {page}, mode);
  return heights_of(*open(path, options));
}

void expect_values(const TiffPageSpec& page, const std::vector<float>& heights,
                   const std::string& what) {
  ASSERT_EQ(heights.size(), static_cast<std::size_t>(page.width * page.height)) << what;
  for (int j = 0; j < page.height; ++j) {
    for (int i = 0; i < page.width; ++i) {
      const float height = heights[static_cast<std::size_t>(j * page.width + i)];
      ASSERT_EQ(height, static_cast<float>(page.value(i, j))) << what << ' ' << i << ' ' << j;
    }
  }
}

struct TypeRow {
  const char* name;
  int bits, format;
  double lowest, highest;
};
const std::vector<TypeRow> kTypes = {{"uint8", 8, 1, 0, 255},
                                     {"int8", 8, 2, -128, 127},
                                     {"uint16", 16, 1, 0, 65535},
                                     {"int16", 16, 2, -32768, 32767},
                                     {"uint32", 32, 1, 0, 4294967040.0},
                                     {"int32", 32, 2, -2147483648.0, 2147483520.0},
                                     {"uint64", 64, 1, 0, 1e15},
                                     {"int64", 64, 2, -1e15, 1e15},
                                     {"float16", 16, 3, -60000, 60000},
                                     {"float24", 24, 3, -1e6, 1e6},
                                     {"float32", 32, 3, -11000.25, 8848.75},
                                     {"float64", 64, 3, -11000.125, 8848.125}};

TEST(GeoTiffSamples, AreOfEachTypeInEachOrderOfBytes) {
  for (const TypeRow& type : kTypes) {
    for (const char* mode : {"wl", "wb", "wl8", "wb8"}) {
      for (const int tile : {0, 16}) {
        TiffPageSpec page;
        page.bits = type.bits;
        page.format = type.format;
        page.tile = tile;
        page.value = [&type](int i, int j) {
          if (i == 0 && j == 0) return type.lowest;
          return i == 1 && j == 0 ? type.highest : static_cast<double>(i + 2 * j);
        };
        if (type.bits == 16 && type.format == 3) {
          page.value = [](int i, int j) { return i == 0 ? -60000.0 : i + 2.0 * j; };
        }
        if (type.bits == 24) {
          page.value = [](int i, int j) { return i == 0 ? -1000000.0 : i + 0.25 * j; };
        }
        expect_values(page, through_file(page, mode), std::string(type.name) + mode);
      }
    }
  }
}

TEST(GeoTiffSamples, AreDecodedByEachCodec) {
  struct Row {
    int compression;
    bool only_bytes;
  };
  for (const Row& row : {Row{COMPRESSION_NONE, false}, Row{COMPRESSION_LZW, false},
                         Row{COMPRESSION_ADOBE_DEFLATE, false}, Row{COMPRESSION_DEFLATE, false},
                         Row{COMPRESSION_PACKBITS, false}, Row{COMPRESSION_LZMA, false},
                         Row{COMPRESSION_ZSTD, false}, Row{COMPRESSION_LERC, false}}) {
    // A build of libtiff without a codec cannot write the file either.
    if (TIFFIsCODECConfigured(static_cast<std::uint16_t>(row.compression)) == 0) continue;
    for (const int bits : {16, 32}) {
      TiffPageSpec page;
      page.compression = row.compression;
      page.bits = bits;
      page.format = bits == 32 ? 3 : 2;
      page.tile = 16;
      expect_values(page, through_file(page), "codec " + std::to_string(row.compression));
    }
  }
}

TEST(GeoTiffSamples, AreDecodedFromJpeg) {
  TiffPageSpec page;
  page.compression = COMPRESSION_JPEG;
  page.bits = 8;
  page.format = 1;
  page.tile = 16;
  page.value = [](int i, int j) { return 100.0 + i + j; };
  const std::vector<float> heights = through_file(page);
  EXPECT_NEAR(heights[static_cast<std::size_t>(5 * page.width + 7)], 112.0f, 8.0f);
}

TEST(GeoTiffSamples, AreDecodedWithEachPredictor) {
  struct Row {
    int bits, format, predictor;
  };
  for (const Row& row : {Row{8, 1, 2}, Row{16, 2, 2}, Row{32, 2, 2}, Row{64, 2, 2}, Row{32, 3, 2},
                         Row{16, 3, 3}, Row{24, 3, 3}, Row{32, 3, 3}, Row{64, 3, 3}}) {
    for (const char* mode : {"wl", "wb"}) {
      // libtiff 4.5 itself writes such files with all bytes in the wrong order.
      if (row.predictor == 3 && mode[1] == 'b') continue;
      TiffPageSpec page;
      page.compression = COMPRESSION_ADOBE_DEFLATE;
      page.bits = row.bits;
      page.format = row.format;
      page.predictor = row.predictor;
      expect_values(
          page, through_file(page, mode),
          mode + std::to_string(row.bits) + " bits, predictor " + std::to_string(row.predictor));
    }
  }
}

TEST(GeoTiffSamples, AreThoseOfTheFirstBand) {
  for (const bool apart : {false, true}) {
    for (const int tile : {0, 16}) {
      TiffPageSpec page;
      page.bands = 4;
      page.bands_apart = apart;
      page.tile = tile;
      expect_values(page, through_file(page), apart ? "apart" : "together");
    }
  }
}

TEST(GeoTiffSamples, LieInStripsOfAnyHeight) {
  for (const int rows : {1, 7, 29, 1000}) {
    TiffPageSpec page;
    page.rows_per_strip = rows;
    page.compression = COMPRESSION_LZW;
    expect_values(page, through_file(page), std::to_string(rows));
    page.compression = COMPRESSION_NONE;
    expect_values(page, through_file(page), std::to_string(rows));
  }
}

TEST(GeoTiffSamples, OfAWindowAreThoseOfTheWhole) {
  const Folder folder;
  TiffPageSpec page;
  page.tile = 16;
  page.compression = COMPRESSION_ADOBE_DEFLATE;
  write_tiff(folder.path() / "a.tif", {page});
  const auto raster = open(folder.path() / "a.tif");
  for (const Window& window : {Window{0, 0, 1, 1}, Window{15, 15, 2, 2}, Window{36, 28, 1, 1},
                               Window{3, 0, 30, 29}, Window{0, 17, 37, 1}}) {
    std::vector<float> heights(static_cast<std::size_t>(window.width * window.height));
    raster->read(window, heights.data());
    for (int j = 0; j < window.height; ++j) {
      for (int i = 0; i < window.width; ++i) {
        EXPECT_EQ(heights[static_cast<std::size_t>(j * window.width + i)],
                  static_cast<float>(page.value(window.column + i, window.row + j)));
      }
    }
  }
}

TEST(GeoTiffSamples, AreReadByManyThreadsAtOnce) {
  const Folder folder;
  TiffPageSpec page;
  page.width = page.height = 200;
  page.tile = 16;
  page.compression = COMPRESSION_ADOBE_DEFLATE;
  write_tiff(folder.path() / "a.tif", {page});
  const auto raster = open(folder.path() / "a.tif");
  std::vector<std::vector<float>> results(4);
  std::vector<std::thread> threads;
  for (std::vector<float>& result : results) {
    threads.emplace_back([&] { result = heights_of(*raster); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<float>& result : results) expect_values(page, result, "thread");
}

struct VoidRow {
  const char* nodata;  // as the file gives it
  int bits, format;
  double stored;
  bool is_void;
};

TEST(GeoTiffVoids, AreTheNodataValueInTheTypeOfTheFile) {
  const double lowest = -static_cast<double>(std::numeric_limits<float>::max());
  const std::vector<VoidRow> rows = {
      {"-9999", 16, 2, -9999, true},
      {"-9999.0", 16, 2, -9999, true},
      {" -9999 ", 32, 3, -9999, true},
      {"32767", 16, 2, 32767, true},
      {"65535", 16, 1, 65535, true},
      {"65535", 16, 1, 0, false},
      {"-1", 16, 1, 65535, false},
      {"0", 8, 1, 0, true},
      {"", 8, 1, 0, false},
      {"255", 8, 1, 255, true},
      {"-3.4028234663852886e+38", 32, 3, lowest, true},
      {"-3.4e+38", 32, 3, lowest, true},
      {"-3.40282306074e+38", 32, 3, lowest, true},
      {"", 32, 3, lowest, true},
      {"", 64, 3, -1e31, true},
      {"-1.7976931348623157e+308", 32, 3, lowest, true},
      {"0.1", 32, 3, static_cast<double>(0.1f), true},
      {"0.1", 64, 3, 0.1, true},
      {"0.1", 64, 3, static_cast<double>(0.1f), false},
      {"-999.6", 16, 3, -999.5, true},  // half floats are half a metre apart there
      {"nan", 32, 3, std::nan(""), true},
      {"-9999", 32, 3, std::nan(""), true},
      {"", 32, 3, std::nan(""), true},
      {"", 64, 3, HUGE_VAL, true},
      {"", 16, 3, std::nan(""), true},
      {"1.5", 16, 2, 1, false},
      {"nonsense", 32, 3, 5, false},
      {"-9223372036854775808", 64, 2, -9223372036854775808.0, true},
      {"0", 32, 3, 0, true},
      {"", 16, 2, -430, false},
      {"", 16, 2, -32768, false},  // undeclared marks are for the caller
      {"-32768", 16, 2, -32767, false}};
  for (const VoidRow& row : rows) {
    TiffPageSpec page;
    page.nodata = row.nodata;
    page.bits = row.bits;
    page.format = row.format;
    page.value = [&row](int i, int j) { return i == 3 && j == 2 ? row.stored : 20.0 + i; };
    const std::vector<float> heights = through_file(page);
    const float height = heights[static_cast<std::size_t>(2 * page.width + 3)];
    EXPECT_EQ(std::isnan(height), row.is_void) << row.nodata << ", stored " << row.stored;
    EXPECT_EQ(heights[0], 20.0f) << row.nodata;
  }
}

TEST(GeoTiffVoids, AreWhatTheUserSays) {
  TiffPageSpec page;
  page.nodata = "7";
  page.metadata =
      "<GDALMetadata><Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.1</Item>"
      "</GDALMetadata>";
  page.value = [](int i, int) { return i == 0 ? -9999.0 : 7.0; };
  OpenOptions options;
  options.nodata = -9999.0;
  const std::vector<float> heights = through_file(page, "w", options);
  EXPECT_TRUE(std::isnan(heights[0]));
  EXPECT_FLOAT_EQ(heights[1], 0.7f);
}

TEST(GeoTiffVoids, AreUnderMasks) {
  const Folder folder;
  for (const int bits : {1, 8}) {
    TiffPageSpec page, mask;
    mask.subfile = FILETYPE_MASK;
    mask.photometric = PHOTOMETRIC_MASK;
    mask.bits = bits;
    mask.format = 1;
    mask.value = [bits](int i, int j) { return (i + j) % 3 == 0 ? 0.0 : bits == 1 ? 1.0 : 255.0; };
    if (bits == 8) mask.photometric = PHOTOMETRIC_MINISBLACK;
    write_tiff(folder.path() / "a.tif", {page, mask});
    const auto heights = heights_of(*open(folder.path() / "a.tif"));
    for (int j = 0; j < page.height; ++j) {
      for (int i = 0; i < page.width; ++i) {
        const float height = heights[static_cast<std::size_t>(j * page.width + i)];
        EXPECT_EQ(std::isnan(height), (i + j) % 3 == 0) << bits << ' ' << i << ' ' << j;
      }
    }
  }
}

TEST(GeoTiffVoids, AreTransparent) {
  for (const bool apart : {false, true}) {
    TiffPageSpec page;
    page.bits = 16;
    page.format = 2;
    page.bands = 3;
    page.bands_apart = apart;
    page.last_is_opacity = true;
    page.tile = 16;
    page.other = [](int i, int) { return i == 20 ? 0.0 : 255.0; };
    const std::vector<float> heights = through_file(page);
    EXPECT_TRUE(std::isnan(heights[20]));
    EXPECT_EQ(heights[21], 63.0f);
  }
}

TEST(GeoTiffVoids, AreBlocksThatTheFileLeavesOut) {
  for (const char* nodata : {"", "-9999"}) {
    TiffPageSpec page;
    page.tile = 16;
    page.nodata = nodata;
    page.first_missing_block = 5;
    const std::vector<float> heights = through_file(page);
    EXPECT_EQ(heights[0], 0.0f);
    const float last = heights.back();
    EXPECT_TRUE(*nodata == '\0' ? last == 0.0f : std::isnan(last)) << last;
  }
}

TEST(GeoTiffHeights, FollowScaleOffsetAndUnit) {
  const std::string metadata =
      "<GDALMetadata>\n <Item name=\"STATISTICS_MEAN\" sample=\"0\">7</Item>\n"
      "<Item name=\"OFFSET\" sample=\"0\" role=\"offset\">-1000</Item>\n"
      "<Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.5</Item>\n"
      "<Item name=\"SCALE\" sample=\"1\" role=\"scale\">3</Item>\n"
      "<Item name=\"UNITTYPE\" sample=\"0\" role=\"unittype\">US survey foot</Item>\n"
      "</GDALMetadata>";
  TiffPageSpec page;
  page.bits = 16;
  page.format = 1;
  page.nodata = "0";
  page.metadata = metadata;
  page.value = [](int i, int) { return 2.0 * i; };
  const Folder folder;
  write_tiff(folder.path() / "a.tif", {page});
  const auto raster = open(folder.path() / "a.tif");
  EXPECT_EQ(raster->info().unit, "US survey foot");
  EXPECT_TRUE(has_note(*raster, "times 0.5 plus -1000"));
  EXPECT_FALSE(has_note(*raster, "no unit"));
  EXPECT_TRUE(std::isnan(height_at(*raster, 0, 0)));
  EXPECT_NEAR(height_at(*raster, 10, 0), (10.0 - 1000.0) * 1200.0 / 3937.0, 1e-3);

  OpenOptions options;
  options.metres_per_unit = 0.01;
  EXPECT_NEAR(height_at(*open(folder.path() / "a.tif", options), 10, 0), -9.9, 1e-5);
  options.image_heights_m = {100.0, 1000.0};
  page.nodata = "";
  page.value = [](int i, int) { return i == 0 ? 0.0 : 65535.0; };
  write_tiff(folder.path() / "b.tif", {page});
  EXPECT_FLOAT_EQ(height_at(*open(folder.path() / "b.tif", options), 0, 0), 100.0f);
  EXPECT_FLOAT_EQ(height_at(*open(folder.path() / "b.tif", options), 1, 0), 1000.0f);
}

TEST(GeoTiffHeights, SayWhatWasGuessed) {
  const Folder folder;
  TiffPageSpec page;
  page.bits = 16;
  page.format = 1;
  page.nodata = "-9999";
  page.bands = 2;
  write_tiff(folder.path() / "a.tif", {page, page});
  const auto raster = open(folder.path() / "a.tif");
  EXPECT_EQ(raster->info().sample_type, "uint16");
  EXPECT_TRUE(has_note(*raster, "Heights are taken as metres because the file gives no unit."));
  EXPECT_TRUE(has_note(*raster, "2 bands"));
  EXPECT_TRUE(has_note(*raster, "2 pages"));
  EXPECT_TRUE(has_note(*raster, "by -9999, which samples of its type (uint16) cannot be"));
}

}  // namespace
}  // namespace aerostat::elevation
