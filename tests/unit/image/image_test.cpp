// Tests the encoders with other decoders.

#include <cmath>
#include <cstring>
#include <random>
#include <type_traits>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "image/write.hpp"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace aerostat::image {
namespace {

Pixels random_pixels(int width, int height) {
  Pixels pixels{width, height, {}};
  std::mt19937 random(11);
  for (int i = 0; i < 3 * width * height; ++i) {
    pixels.rgb.push_back(static_cast<std::uint8_t>(random()));
  }
  return pixels;
}

TEST(Png, DecodesToTheSamePixels) {
  for (auto [width, height] : {std::pair{1, 1}, {7, 3}, {64, 65}, {1000, 300}}) {
    const Pixels pixels = random_pixels(width, height);
    const auto png = encode_png(pixels);
    int w = 0, h = 0, channels = 0;
    stbi_uc* back =
        stbi_load_from_memory(png.data(), static_cast<int>(png.size()), &w, &h, &channels, 0);
    ASSERT_NE(back, nullptr);
    EXPECT_EQ(w, width);
    EXPECT_EQ(h, height);
    ASSERT_EQ(channels, 3);
    EXPECT_EQ(std::memcmp(back, pixels.rgb.data(), pixels.rgb.size()), 0);
    stbi_image_free(back);
  }
}

/// Returns the checksum of a chunk, computed bit by bit as annex D of the standard defines it.
std::uint32_t checksum(const std::uint8_t* bytes, std::size_t count) {
  std::uint32_t sum = ~0u;
  for (std::size_t i = 0; i < count; ++i) {
    sum ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1u) != 0 ? 0xEDB88320u : 0u);
  }
  return ~sum;
}

TEST(Png, HasChunksWithTheirChecksums) {
  const auto png = encode_png(random_pixels(300, 200));
  const auto word = [&png](std::size_t at) {
    return std::uint32_t{png[at]} << 24 | std::uint32_t{png[at + 1]} << 16 |
           std::uint32_t{png[at + 2]} << 8 | png[at + 3];
  };
  std::string types;
  std::size_t at = 8;
  while (at + 12 <= png.size()) {
    const std::size_t length = word(at);
    ASSERT_LE(at + 12 + length, png.size());
    types.append(png.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                 png.begin() + static_cast<std::ptrdiff_t>(at) + 8);
    EXPECT_EQ(word(at + 8 + length), checksum(&png[at + 4], length + 4)) << types;
    at += 12 + length;
  }
  EXPECT_EQ(at, png.size());
  EXPECT_EQ(types, "IHDRIDATIEND");
}

TEST(Png, RefusesWhatTheEncoderCannotCount) {
  EXPECT_TRUE(png_can_hold(16384, 16384));
  EXPECT_FALSE(png_can_hold(32768, 32768));
  EXPECT_FALSE(png_can_hold(0, 5));
  Pixels wrong = random_pixels(4, 4);
  wrong.height = 5;
  EXPECT_THROW(encode_png(wrong), Error);
}

/// A file in memory for OpenEXR's reader.
class MemoryInput : public Imf::IStream {
 public:
  explicit MemoryInput(const std::vector<std::uint8_t>& bytes)
      : Imf::IStream("memory"), bytes_(bytes) {}

  bool read(char into[], int count) override {
    const auto n = static_cast<std::size_t>(count);
    if (position_ + n > bytes_.size()) throw std::runtime_error("read past the end");
    std::memcpy(into, bytes_.data() + position_, n);
    position_ += n;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  const std::vector<std::uint8_t>& bytes_;
  std::size_t position_ = 0;
};

Film example_film(int width, int height) {
  Film film;
  film.width = width;
  film.height = height;
  for (int i = 0; i < width * height; ++i) {
    const auto v = static_cast<float>(i);
    const bool is_sky = i % 5 == 0;
    film.radiance.push_back({v, v + 0.25f, v * 1000.5f});
    film.alpha.push_back(is_sky ? 0.0f : 1.0f);
    film.distance_m.push_back(is_sky ? kInfinity : 10.0f * v);
    film.normal_ws.push_back(is_sky ? vec3(0.0f) : vec3(0.6f, 0.0f, -0.8f));
    film.albedo.push_back(is_sky ? vec3(0.0f) : vec3(0.25f, 0.5f, 0.01f * v));
    film.object_id.push_back(is_sky ? 0u : 4000000000u + static_cast<unsigned>(i));
  }
  return film;
}

template <typename T>
Array<T> read_channel(const std::vector<std::uint8_t>& bytes, const char* name) {
  MemoryInput stream(bytes);
  Imf::InputFile file(stream);
  const Imf::Channel* channel = file.header().channels().findChannel(name);
  if (!channel) return {};
  const auto window = file.header().dataWindow();
  const auto width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
  const auto height = static_cast<std::size_t>(window.max.y - window.min.y + 1);
  Array<T> values(width * height);
  Imf::FrameBuffer frame;
  frame.insert(name, Imf::Slice::Make(std::is_same_v<T, float> ? Imf::FLOAT : Imf::UINT,
                                      values.data(), window, sizeof(T)));
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  EXPECT_EQ(channel->type, (std::is_same_v<T, float> ? Imf::FLOAT : Imf::UINT)) << name;
  return values;
}

TEST(Exr, ReadsBackAsWritten) {
  const Film film = example_film(19, 37);
  const auto bytes = encode_exr(film);
  Array<float> expected[9];
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      expected[c].push_back(film.radiance[i][c]);
      expected[3 + c].push_back(film.normal_ws[i][c]);
      expected[6 + c].push_back(film.albedo[i][c]);
    }
  }
  const char* names[] = {"R", "G", "B", "N.X", "N.Y", "N.Z", "albedo.R", "albedo.G", "albedo.B"};
  for (int c = 0; c < 9; ++c) EXPECT_EQ(read_channel<float>(bytes, names[c]), expected[c]);
  EXPECT_EQ(read_channel<float>(bytes, "A"), film.alpha);
  EXPECT_EQ(read_channel<float>(bytes, "Z"), film.distance_m);
  EXPECT_EQ(read_channel<std::uint32_t>(bytes, "id"), film.object_id);
  EXPECT_TRUE(std::isinf(read_channel<float>(bytes, "Z")[0]));
}

TEST(Exr, HasASaneHeader) {
  const auto bytes = encode_exr(example_film(4, 3));
  MemoryInput stream(bytes);
  Imf::InputFile file(stream);
  EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
  EXPECT_EQ(file.header().displayWindow(), file.header().dataWindow());
  EXPECT_FLOAT_EQ(Imf::chromaticities(file.header()).red.x, 0.64f);
  EXPECT_FLOAT_EQ(Imf::chromaticities(file.header()).white.y, 0.329f);
  EXPECT_TRUE(file.isComplete());
}

TEST(Exr, OfAPartSaysWhereItBelongs) {
  Film film = example_film(5, 3);
  film.first = {100, 30000};
  film.whole = {32768, 32768};
  const auto bytes = encode_exr(film);
  MemoryInput stream(bytes);
  Imf::InputFile file(stream);
  EXPECT_EQ(file.header().dataWindow(), Imath::Box2i({100, 30000}, {104, 30002}));
  EXPECT_EQ(file.header().displayWindow(), Imath::Box2i({0, 0}, {32767, 32767}));
  EXPECT_EQ(read_channel<float>(bytes, "Z"), film.distance_m);
  EXPECT_EQ(read_channel<std::uint32_t>(bytes, "id"), film.object_id);
}

TEST(Exr, LeavesOutWhatTheFilmLacks) {
  Film film = example_film(4, 3);
  film.object_id.clear();
  film.normal_ws.clear();
  film.albedo.clear();
  const auto bytes = encode_exr(film);
  EXPECT_TRUE(read_channel<std::uint32_t>(bytes, "id").empty());
  EXPECT_TRUE(read_channel<float>(bytes, "N.X").empty());
  EXPECT_TRUE(read_channel<float>(bytes, "albedo.R").empty());
  EXPECT_EQ(read_channel<float>(bytes, "Z"), film.distance_m);
}

TEST(Exr, RefusesALayerOfTheWrongLength) {
  Film film = example_film(4, 3);
  film.alpha.pop_back();
  EXPECT_THROW(encode_exr(film), Error);
}

TEST(Encoders, AreDeterministic) {
  const Film film = example_film(33, 20);
  EXPECT_EQ(encode_exr(film), encode_exr(film));
  EXPECT_EQ(encode_png(develop(film, -3.0)), encode_png(develop(film, -3.0)));
}

}  // namespace
}  // namespace aerostat::image
