// The traps of samples without a description, or with one in a .hdr file.

#include "elevation/raw.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "files.hpp"

namespace aerostat::elevation {
namespace {

template <typename T>
std::string little_endian(const std::vector<T>& values) {
  std::string bytes;
  for (const T& value : values) {
    const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    bytes.append(raw.data(), raw.size());
  }
  return bytes;
}

template <typename T>
std::string big_endian(const std::vector<T>& values) {
  std::string bytes;
  for (const T& value : values) {
    const std::string one = little_endian<T>({value});
    bytes.append(one.rbegin(), one.rend());
  }
  return bytes;
}

OpenOptions said(double low, double high) {
  OpenOptions options;
  options.image_heights_m = {low, high};
  options.cell_m = 10.0;
  return options;
}

OpenOptions cell() {
  OpenOptions options;
  options.cell_m = 10.0;
  return options;
}

TEST(Raw, R16IsLittleEndianUnsignedAndSquare) {
  const Folder folder;
  const auto path = folder.write("a.r16", little_endian<std::uint16_t>({0, 65535, 256, 1}));
  EXPECT_EQ(heights_of(*open(path, said(0.0, 65535.0))), (std::vector<float>{0, 65535, 256, 1}));
  EXPECT_TRUE(says(refusal_of([&] { open(path, cell()); }), "/terrain/image_heights_m"));
  OpenOptions options;
  options.image_heights_m = {0.0, 1.0};
  EXPECT_TRUE(says(refusal_of([&] { open(path, options); }), "/terrain/cell_m"));
}

TEST(Raw, R32IsMetresUnlessARangeIsSaid) {
  const Folder folder;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto path = folder.write("a.r32", little_endian<float>({-430.5f, nan, 0.5f, -3.4e38f}));
  const auto raster = open(path, cell());
  EXPECT_EQ(height_at(*raster, 0, 0), -430.5f);
  EXPECT_TRUE(std::isnan(height_at(*raster, 1, 0)));
  EXPECT_TRUE(std::isnan(height_at(*raster, 1, 1)));
  EXPECT_FLOAT_EQ(height_at(*open(path, said(1000.0, 2000.0)), 0, 1), 1500.0f);
}

TEST(Raw, TheSizeMustFitExactly) {
  const Folder folder;
  const auto path = folder.write("a.r16", little_endian<std::uint16_t>({1, 2, 3, 4, 5, 6}));
  OpenOptions options = said(0.0, 65535.0);
  EXPECT_TRUE(says(refusal_of([&] { open(path, options); }),
                   "12 bytes, or 6.00 samples of 2 bytes, which are no square"));
  options.raw.width = 3;
  EXPECT_EQ(open(path, options)->info().height, 2);
  options.raw.height = 3;
  EXPECT_TRUE(says(refusal_of([&] { open(path, options); }),
                   "12 bytes behind its header, and 3 x 3 samples of 2 bytes need 18"));
  options.raw.height = 2;
  options.raw.header_bytes = 12;
  EXPECT_TRUE(says(refusal_of([&] { open(path, options); }), "12 of them were said"));
  options.raw.header_bytes = ~std::uint64_t{0};
  EXPECT_TRUE(says(refusal_of([&] { open(path, options); }), "were said to be its header"));
}

TEST(Raw, TypeOrderAndHeaderMayBeSaid) {
  const Folder folder;
  const auto path = folder.write("a.raw", "head" + big_endian<std::int16_t>({-5, 6, 7, -32768}));
  OpenOptions options = cell();
  options.raw.sample_type = "int16";
  options.raw.big_endian = true;
  options.raw.header_bytes = 4;
  options.nodata = -32768.0;
  const auto raster = open(path, options);
  EXPECT_EQ(height_at(*raster, 0, 0), -5.0f);
  EXPECT_EQ(height_at(*raster, 0, 1), 7.0f);
  EXPECT_TRUE(std::isnan(height_at(*raster, 1, 1)));
  options.raw.sample_type = "word";
  EXPECT_TRUE(
      says(refusal_of([&] { open(path, options); }), "the sample type \"word\" is unknown"));
}

TEST(Raw, EveryTypeIsRead) {
  const Folder folder;
  const auto value_of = [&](const char* type, const std::string& bytes) {
    OpenOptions options = cell();
    options.metres_per_unit = 1.0;
    options.raw.sample_type = type;
    return height_at(*open(folder.write("a.raw", bytes), options), 0, 0);
  };
  EXPECT_EQ(value_of("uint8", little_endian<std::uint8_t>({200, 0, 0, 0})), 200.0f);
  EXPECT_EQ(value_of("int8", little_endian<std::int8_t>({-100, 0, 0, 0})), -100.0f);
  EXPECT_EQ(value_of("uint16", little_endian<std::uint16_t>({60000, 0, 0, 0})), 60000.0f);
  EXPECT_EQ(value_of("int16", little_endian<std::int16_t>({-300, 0, 0, 0})), -300.0f);
  EXPECT_EQ(value_of("uint32", little_endian<std::uint32_t>({70000, 0, 0, 0})), 70000.0f);
  EXPECT_EQ(value_of("int32", little_endian<std::int32_t>({-70000, 0, 0, 0})), -70000.0f);
  EXPECT_EQ(value_of("float32", little_endian<float>({1.5f, 0, 0, 0})), 1.5f);
  EXPECT_EQ(value_of("float64", little_endian<double>({-2.25, 0, 0, 0})), -2.25f);
}

TEST(Raw, TheTypeOfARawFileFollowsFromItsSizeAndIsSaid) {
  const Folder folder;
  const auto shorts = folder.write("a.raw", little_endian<std::uint16_t>({1, 2, 3, 4}));
  EXPECT_TRUE(has_note(*open(shorts, said(0.0, 65535.0)), "uint16 was taken"));
  OpenOptions options = cell();
  options.raw.width = 3;
  options.raw.height = 2;
  const auto floats = folder.write("b.raw", little_endian<float>({1, 2, 3, 4, 5, 6}));
  EXPECT_TRUE(has_note(*open(floats, options), "float32 was taken"));
  const auto neither = folder.write("c.raw", "seven b");
  EXPECT_TRUE(says(refusal_of([&] { open(neither, cell()); }), "7 bytes of samples, which fit no"));
}

TEST(Raw, TheWrongOrderOfBytesIsSaid) {
  std::vector<std::uint16_t> slope;
  std::vector<float> floats;
  for (int i = 0; i < 64 * 64; ++i) {
    slope.push_back(static_cast<std::uint16_t>(20000 + i));
    floats.push_back(static_cast<float>(1000 + i));
  }
  const Folder folder;
  const auto right = folder.write("a.r16", little_endian(slope));
  const auto wrong = folder.write("b.r16", big_endian(slope));
  EXPECT_FALSE(has_note(*open(right, said(0.0, 1.0)), "order of bytes"));
  EXPECT_TRUE(has_note(*open(wrong, said(0.0, 1.0)), "order of bytes"));
  const auto right_floats = folder.write("a.r32", little_endian(floats));
  const auto wrong_floats = folder.write("b.r32", big_endian(floats));
  EXPECT_FALSE(has_note(*open(right_floats, cell()), "order of bytes"));
  EXPECT_TRUE(has_note(*open(wrong_floats, cell()), "order of bytes"));
}

TEST(Bil, TheHdrFileDescribesTheSamples) {
  const Folder folder;
  const auto path =
      folder.write("a.bil", "??" + big_endian<std::int16_t>({1, -2, 3, 0, -9999, 5, 6, 0}));
  folder.write("a.hdr",
               "BYTEORDER M\r\nLAYOUT BIL\r\nNROWS 2\r\nNCOLS 3\r\nNBANDS 1\r\nNBITS 16\r\n"
               "SKIPBYTES 2\r\nTOTALROWBYTES 8\r\nULXMAP 20.5\r\nULYMAP 40.5\r\nXDIM 0.5\r\n"
               "YDIM 0.25\r\nNODATA -9999\r\n");
  const auto raster = open(path);
  EXPECT_EQ(height_at(*raster, 1, 0), -2.0f);
  EXPECT_EQ(height_at(*raster, 2, 1), 6.0f);
  EXPECT_TRUE(std::isnan(height_at(*raster, 0, 1)));
  EXPECT_EQ(centre_of(*raster, 0, 0), dvec2(20.5, 40.5));
  EXPECT_EQ(centre_of(*raster, 2, 1), dvec2(21.5, 40.25));
  EXPECT_TRUE(has_note(*raster, "whether heights are signed"));
  EXPECT_TRUE(has_note(*raster, "/terrain/crs"));
}

TEST(Bil, FltHasTheHeaderOfAnEsriGrid) {
  const Folder folder;
  const auto path = folder.write("a.flt", little_endian<float>({1.5f, -9999.0f, 3.0f, 4.0f}));
  folder.write("a.hdr",
               "ncols 2\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\nNODATA_value -9999\n"
               "byteorder LSBFIRST\n");
  const auto raster = open(path);
  EXPECT_EQ(height_at(*raster, 0, 0), 1.5f);
  EXPECT_TRUE(std::isnan(height_at(*raster, 1, 0)));
  EXPECT_EQ(centre_of(*raster, 0, 0), dvec2(105.0, 215.0));
}

TEST(Bil, WhatCannotBeReadSaysWhy) {
  const Folder folder;
  const auto path = folder.write("a.bil", "12345678");
  const auto refused = [&](const std::string& hdr) {
    folder.write("a.hdr", hdr);
    return refusal_of([&] { open(path); });
  };
  EXPECT_TRUE(says(refusal_of([&] { open(path); }), "does not lie beside it"));
  EXPECT_TRUE(says(refused("nrows 2\n"), "\"\" for ncols"));
  EXPECT_TRUE(says(refused("nrows 2\nncols 3\nnbits 16\n"), "3 x 2 samples of int16 need 12"));
  EXPECT_TRUE(says(refused("nrows 2\nncols 2\nnbits 12\n"), "12 bits"));
  EXPECT_TRUE(says(refused("nrows 2\nncols 2\nnbands 3\n"), "3 bands"));
  EXPECT_TRUE(says(refused("nrows 2\nncols 2\ntotalrowbytes 1\n"), "rows of 1 bytes"));
  EXPECT_TRUE(says(refused("nrows 2\nncols 2\ntotalrowbytes 999999999999999\n"), "need 999999999"));
  EXPECT_TRUE(says(refused("nrows 2\nncols 2\nnbits 16\n"), "/terrain/cell_m"));
}

}  // namespace
}  // namespace aerostat::elevation
