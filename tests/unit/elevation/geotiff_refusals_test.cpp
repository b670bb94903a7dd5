// GeoTIFF files that are refused, and those that are damaged.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <tiffio.h>

#include "elevation/open.hpp"
#include "files.hpp"
#include "tiff_files.hpp"

namespace aerostat::elevation {
namespace {

std::string refusal_of_page(const TiffPageSpec& page) {
  const Folder folder;
  write_tiff(folder.path() / "a.tif", {page});
  return refusal_of([&] { open(folder.path() / "a.tif"); });
}

std::string bytes_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Replaces the value of a tag of type SHORT or LONG in the first directory of a little-endian
/// file.
void change_tag(std::string& bytes, std::uint16_t tag, std::uint32_t value) {
  const auto number = [&bytes](std::size_t at, int count) {
    std::uint32_t result = 0;
    for (int i = 0; i < count; ++i) {
      result |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + i))) << 8 * i;
    }
    return result;
  };
  const std::size_t directory = number(4, 4);
  for (std::uint32_t i = 0; i < number(directory, 2); ++i) {
    const std::size_t entry = directory + 2 + 12 * std::size_t{i};
    if (number(entry, 2) != tag) continue;
    const int size = number(entry + 2, 2) == TIFF_SHORT ? 2 : 4;
    for (int k = 0; k < size; ++k) bytes.at(entry + 8 + k) = static_cast<char>(value >> 8 * k);
  }
}

// A palette is for viewers. Codes have neither units nor scales.
TEST(GeoTiffCodes, OfAPaletteAreReadAsTheyAreStored) {
  TiffPageSpec page = page_at(32632, 500000.0, 5200000.0, 30.0);
  page.bits = 8;
  page.format = 1;
  page.photometric = PHOTOMETRIC_PALETTE;
  page.value = [](int i, int) { return i == 0 ? 255.0 : 41.0 + i; };
  page.nodata = "255";
  page.metadata =
      "<GDALMetadata><Item name=\"LAYER_TYPE\">thematic</Item>"
      "<Item name=\"SCALE\" sample=\"0\" role=\"scale\">10</Item></GDALMetadata>";
  const Folder folder;
  write_tiff(folder.path() / "a.tif", {page});
  OpenOptions options;
  options.codes = true;
  const auto raster = open(folder.path() / "a.tif", options);
  std::vector<float> codes(3);
  raster->read({0, 4, 3, 1}, codes.data());
  EXPECT_TRUE(std::isnan(codes[0]));
  EXPECT_EQ(codes[1], 42.0f);
  EXPECT_EQ(codes[2], 43.0f);
  page.photometric = PHOTOMETRIC_RGB;
  page.bands = 3;
  write_tiff(folder.path() / "b.tif", {page});
  EXPECT_TRUE(says(refusal_of([&] { open(folder.path() / "b.tif", options); }),
                   "whose codes of classes are not known"));
}

TEST(GeoTiffRefusals, NameWhatIsNoHeights) {
  TiffPageSpec page;
  page.bits = 8;
  page.format = 1;
  page.bands = 3;
  page.photometric = PHOTOMETRIC_RGB;
  EXPECT_TRUE(says(refusal_of_page(page), "image in colours, not heights"));
  page.bands = 1;
  page.photometric = PHOTOMETRIC_PALETTE;
  EXPECT_TRUE(says(refusal_of_page(page), "palette, not heights"));
  page.photometric = PHOTOMETRIC_MINISBLACK;
  page.metadata = "<Item name=\"LAYER_TYPE\" sample=\"0\">thematic</Item>";
  EXPECT_TRUE(says(refusal_of_page(page), "classes, not of heights"));
  page.metadata.clear();
  for (const int bits : {32, 64}) {
    page.bits = bits;
    for (const int format : {SAMPLEFORMAT_COMPLEXINT, SAMPLEFORMAT_COMPLEXIEEEFP}) {
      page.format = format;
      EXPECT_TRUE(says(refusal_of_page(page), "complex numbers, not heights"));
    }
  }
  page.format = 1;
  page.bits = 1;
  EXPECT_TRUE(says(refusal_of_page(page), "samples of 1 bits (integers)"));
  page.bits = 8;
  page.width = 1;
  EXPECT_TRUE(says(refusal_of_page(page), "1 x 29 samples"));
}

TEST(GeoTiffRefusals, NameTheCodec) {
  const Folder folder;
  write_tiff(folder.path() / "a.tif", {TiffPageSpec()}, "wl");
  std::string bytes = bytes_of_file(folder.path() / "a.tif");
  for (const auto& [code, name] : std::vector<std::pair<std::uint32_t, std::string>>{
           {50002, "JPEG XL (50002)"}, {34712, "JPEG 2000 (34712)"}, {60000, "number 60000"}}) {
    change_tag(bytes, TIFFTAG_COMPRESSION, code);
    const auto path = folder.write("b.tif", bytes);
    EXPECT_TRUE(says(refusal_of([&] { open(path); }), "compressed by " + name));
  }
}

TEST(GeoTiffRefusals, BoundSizesBeforeAnythingIsRead) {
  const Folder folder;
  TiffPageSpec page;
  page.compression = COMPRESSION_ADOBE_DEFLATE;
  write_tiff(folder.path() / "a.tif", {page}, "wl");
  const std::string plain = bytes_of_file(folder.path() / "a.tif");
  struct Row {
    std::vector<std::pair<std::uint16_t, std::uint32_t>> tags;
    const char* says;
  };
  for (const Row& row :
       {Row{{{TIFFTAG_IMAGEWIDTH, 0xFFFF}, {TIFFTAG_IMAGELENGTH, 0}}, "zero number of strips"},
        Row{{{TIFFTAG_ROWSPERSTRIP, 0}}, "(Bad value 0 for \"RowsPerStrip\" tag)"},
        Row{{{TIFFTAG_SAMPLESPERPIXEL, 0xFFFF}}, "65535 bands"},
        Row{{{TIFFTAG_IMAGEWIDTH, 16384},
             {TIFFTAG_IMAGELENGTH, 16384},
             {TIFFTAG_ROWSPERSTRIP, 16384},
             {TIFFTAG_BITSPERSAMPLE, 8},
             {TIFFTAG_SAMPLEFORMAT, 1}},
            "268435456 bytes, and at most 134217728 samples"},
        Row{{{TIFFTAG_IMAGEWIDTH, 0xFFFF},
             {TIFFTAG_IMAGELENGTH, 0xFFFF},
             {TIFFTAG_ROWSPERSTRIP, 0xFFFF}},
            "at most 134217728 samples"}}) {
    std::string bytes = plain;
    for (const auto& [tag, value] : row.tags) change_tag(bytes, tag, value);
    const auto path = folder.write("b.tif", bytes);
    EXPECT_TRUE(says(refusal_of([&] { open(path); }), row.says));
  }
}

TEST(GeoTiffRefusals, NameADamagedBlock) {
  const Folder folder;
  TiffPageSpec page;
  page.compression = COMPRESSION_ADOBE_DEFLATE;
  page.tile = 16;
  write_tiff(folder.path() / "a.tif", {page}, "wl");
  std::string bytes = bytes_of_file(folder.path() / "a.tif");
  for (std::size_t i = 12; i < 40; ++i) bytes[i] = static_cast<char>(0xAA);
  const auto raster = open(folder.write("b.tif", bytes));
  const std::string damaged = refusal_of([&] { height_at(*raster, 0, 0); });
  EXPECT_TRUE(
      says(damaged, "b.tif: the file is damaged: the tile at column 0, row 0 cannot be read"));
  EXPECT_EQ(height_at(*raster, 36, 28), static_cast<float>(page.value(36, 28)));
  EXPECT_TRUE(
      says(refusal_of([&] { open(folder.write("c.tif", bytes.substr(0, 100))); }), "damaged"));
  EXPECT_TRUE(
      says(refusal_of([&] { open(folder.write("d.tif", std::string("II*\0\0\0\0\0", 8))); }),
           "damaged"));
}

TEST(GeoTiffRefusals, DoNotReadAFileThatTookItsName) {
  const Folder folder;
  TiffPageSpec page;
  write_tiff(folder.path() / "a.tif", {page});
  const auto raster = open(folder.path() / "a.tif");
  std::filesystem::remove(folder.path() / "a.tif");
  folder.write("a.tif", "something else");
  EXPECT_EQ(height_at(*raster, 30, 20), static_cast<float>(page.value(30, 20)));
}

/// Opens a file and reads it, if it is not too large. Any outcome is right but a crash, another
/// kind of error or a message without the name of the file.
void read_all(const std::filesystem::path& path) {
  try {
    const auto raster = open(path);
    const RasterInfo& info = raster->info();
    const Window window{0, 0, std::min(info.width, 200), std::min(info.height, 200)};
    std::vector<float> heights(200 * 200);
    raster->read(window, heights.data());
    for (std::size_t i = 0; i < raster->overview_factors().size(); ++i) {
      const auto [width, height] = raster->overview_size(static_cast<int>(i));
      raster->read_overview(static_cast<int>(i),
                            {0, 0, std::min(width, 200), std::min(height, 200)}, heights.data());
    }
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data) << error.what();
    EXPECT_NE(std::string(error.what()).find("a.tif"), std::string::npos) << error.what();
  }
}

TEST(GeoTiffRefusals, SurviveRandomDamage) {
  const Folder folder;
  std::vector<std::string> seeds;
  for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE,
                                COMPRESSION_PACKBITS, COMPRESSION_ZSTD, COMPRESSION_LERC}) {
    TiffPageSpec page = page_at(32632, 600000.0, 5200000.0, 30.0);
    page.compression = compression;
    page.nodata = "-9999";
    page.metadata = "<Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.5</Item>";
    if (compression != COMPRESSION_LZW) page.tile = 16;
    if (compression == COMPRESSION_LZW) page.predictor = 3;
    TiffPageSpec overview = page;
    overview.width = 19;
    overview.height = 15;
    overview.subfile = FILETYPE_REDUCEDIMAGE;
    if (TIFFIsCODECConfigured(static_cast<std::uint16_t>(compression)) == 0) continue;
    write_tiff(folder.path() / "seed.tif", {page, overview});
    seeds.push_back(bytes_of_file(folder.path() / "seed.tif"));
  }
  // The generator gives the same numbers with every library, as distributions do not.
  std::mt19937 random(20261130);
  const auto below = [&random](std::size_t count) { return random() % count; };
  for (int round = 0; round < 1200; ++round) {
    std::string bytes = seeds[below(seeds.size())];
    const std::size_t changes = 1 + below(6);
    for (std::size_t i = 0; i < changes; ++i) {
      // The directories, where damage matters most, lie at the end and are small.
      const bool near_end = below(3) != 0;
      const std::size_t at =
          near_end ? bytes.size() - 1 - below(std::min<std::size_t>(bytes.size(), 900))
                   : below(bytes.size());
      static const std::string kBytes("\0\1\2\3\x7f\x80\xfe\xff", 8);
      bytes[at] = below(2) == 0 ? kBytes[below(kBytes.size())]
                                : static_cast<char>(bytes[at] ^ (1 << below(8)));
    }
    if (below(20) == 0) bytes.resize(below(bytes.size()));
    read_all(folder.write("a.tif", "II*" + bytes.substr(std::min<std::size_t>(bytes.size(), 3))));
  }
}

}  // namespace
}  // namespace aerostat::elevation
