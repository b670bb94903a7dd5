// The traps of heights in OpenEXR images: channels, numbers of 16 bits, range and distance.

#include "elevation/exr.hpp"

#include <cmath>
#include <cstddef>
#include <fstream>
#include <ios>
#include <iterator>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <gtest/gtest.h>

#include "files.hpp"

namespace aerostat::elevation {
namespace {

using Names = std::vector<std::string>;

/// Writes an image of 2 x 2 samples whose channels all hold `values`.
std::filesystem::path write(const Folder& folder, const Names& names, std::vector<float> values,
                            bool is_half = false) {
  const std::filesystem::path path = folder.path() / "a.exr";
  std::vector<half> halves(values.begin(), values.end());
  // The window of the data need not begin at the corner.
  Imf::Header header(10, 10);
  header.dataWindow() = {{3, 4}, {4, 5}};
  Imf::FrameBuffer frame;
  for (const std::string& name : names) {
    header.channels().insert(name, Imf::Channel(is_half ? Imf::HALF : Imf::FLOAT));
    const void* first = is_half ? static_cast<const void*>(halves.data()) : values.data();
    frame.insert(name,
                 Imf::Slice::Make(is_half ? Imf::HALF : Imf::FLOAT, first, header.dataWindow()));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(2);
  return path;
}

OpenOptions cell() {
  OpenOptions options;
  options.cell_m = 10.0;
  return options;
}

TEST(Exr, OneChannelIsTheHeight) {
  for (const Names& names : {Names{"Y"}, Names{"R", "G", "B"}, Names{"Z", "A"}, Names{"height"}}) {
    const Folder folder;
    const auto raster = open(write(folder, names, {-430.5f, 2.0f, HUGE_VALF, 4.0f}), cell());
    EXPECT_EQ(height_at(*raster, 0, 0), -430.5f) << names[0];
    EXPECT_EQ(height_at(*raster, 1, 1), 4.0f) << names[0];
    EXPECT_TRUE(std::isnan(height_at(*raster, 0, 1))) << names[0];
    EXPECT_EQ(centre_of(*raster, 0, 0), dvec2(-5.0, 5.0));
    EXPECT_EQ(raster->info().sample_type, "float32");
  }
}

TEST(Exr, AnotherChannelMayBeNamed) {
  const Folder folder;
  const auto path = write(folder, {"a", "b"}, {1, 2, 3, 4});
  EXPECT_TRUE(says(refusal_of([&] { open(path, cell()); }), "the channels a, b; Y, R, Z"));
  OpenOptions options = cell();
  options.variable = "b";
  EXPECT_EQ(height_at(*open(path, options), 1, 0), 2.0f);
  options.variable = "c";
  EXPECT_TRUE(says(refusal_of([&] { open(path, options); }), "none named c"));
}

TEST(Exr, NumbersOf16BitsAreSaidToBeCoarse) {
  const Folder folder;
  const auto high = open(write(folder, {"Y"}, {1.0f, 8848.0f, 5000.0f, 3.0f}, true), cell());
  EXPECT_EQ(height_at(*high, 1, 0), 8848.0f);
  EXPECT_EQ(high->info().sample_type, "float16");
  EXPECT_TRUE(has_note(*high, "steps of 8 m"));
  const auto low = open(write(folder, {"Y"}, {1.0f, 2.0f, 4097.0f, 3.0f}, true), cell());
  EXPECT_TRUE(has_note(*low, "steps of 4 m"));
}

TEST(Exr, AFactorOrARangeScales) {
  const Folder folder;
  const auto path = write(folder, {"Y"}, {0.0f, 1.0f, 0.5f, -9999.0f});
  OpenOptions options = cell();
  options.image_heights_m = {1000.0, 3000.0};
  options.nodata = -9999.0;
  EXPECT_EQ(height_at(*open(path, options), 0, 1), 2000.0f);
  EXPECT_TRUE(std::isnan(height_at(*open(path, options), 1, 1)));
  options.image_heights_m.reset();
  options.metres_per_unit = 1000.0;
  EXPECT_EQ(height_at(*open(path, options), 0, 1), 500.0f);
  EXPECT_TRUE(says(refusal_of([&] { open(path); }), "/terrain/cell_m"));
}

TEST(Exr, DamagedFilesAreRefused) {
  const Folder folder;
  const auto path = write(folder, {"Y"}, {1, 2, 3, 4});
  std::ifstream file(path, std::ios::binary);
  const std::string good(std::istreambuf_iterator<char>(file), {});
  for (const std::size_t length :
       {std::size_t{4}, std::size_t{20}, good.size() / 2, good.size() - 9}) {
    const auto cut = folder.write("b.exr", good.substr(0, length));
    EXPECT_TRUE(says(refusal_of([&] { open(cut, cell()); }), "b.exr: the EXR file is damaged"));
  }
  // OpenEXR would allocate what the length of an attribute says.
  std::string long_attribute = good;
  long_attribute.replace(good.find("chlist") + 7, 4, "\xff\xff\xff\x6f");
  EXPECT_TRUE(says(refusal_of([&] { open(folder.write("b.exr", long_attribute), cell()); }),
                   "channels in its header has 1879048191 bytes"));
  std::string wide = good;
  wide.replace(good.find("box2i") + 6 + 4 + 8, 4, std::string("\xff\xff\x0e\x00", 4));
  EXPECT_TRUE(says(refusal_of([&] { open(folder.write("b.exr", wide), cell()); }), "too few for"));
}

}  // namespace
}  // namespace aerostat::elevation
