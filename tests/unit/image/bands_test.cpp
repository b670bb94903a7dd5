// Tests the files of bands, also those whose headers lie.
#include "image/bands.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "image/mark.hpp"

namespace aerostat::image {
namespace {

constexpr std::size_t kPixels = 12;

/// Returns a band of 4 x 3 pixels of a picture of 4 x 9.
Film band() {
  Film film;
  film.width = 4;
  film.height = 3;
  film.first = {0, 3};
  film.whole = {4, 9};
  film.radiance.resize(kPixels, vec3(0.5f));
  film.alpha.resize(kPixels, 1.0f);
  film.distance_m.resize(kPixels, 7.0f);
  film.normal_ws.resize(kPixels, vec3(0.0f, 1.0f, 0.0f));
  film.albedo.resize(kPixels, vec3(0.25f));
  film.object_id.resize(kPixels, 3);
  film.samples.resize(kPixels, 16);
  return film;
}

std::vector<std::uint8_t> band_file() {
  return encode_band(band(), "mark", {1.5, glm::dmat3(1.0), 0.0});
}

/// Gives a box in the header of a file these numbers: left, top, right and bottom.
void set_box(std::vector<std::uint8_t>& exr, std::string_view name,
             const std::vector<std::int32_t>& box) {
  std::vector<char> key(name.begin(), name.end());
  for (const char c : std::string_view("\0box2i\0\x10\0\0\0", 11)) key.push_back(c);
  const auto at = std::search(exr.begin(), exr.end(), key.begin(), key.end());
  ASSERT_NE(at, exr.end());
  std::memcpy(&*at + key.size(), box.data(), box.size() * sizeof(box[0]));
}

TEST(Bands, AreReadBack) {
  const auto exr = band_file();
  const auto read = decode_band(exr);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->mark, "mark");
  EXPECT_EQ(read->film.first, band().first);
  EXPECT_EQ(read->film.whole, band().whole);
  EXPECT_EQ(read->film.samples, band().samples);
  EXPECT_EQ(read->film.radiance, band().radiance);
  EXPECT_EQ(read->development.exposure_ev, 1.5);
  EXPECT_TRUE(mark_of_exr(exr).is_whole);
}

/// Leaves this process 256 MiB more of addresses than it has while the object lives.
class LittleMemory {
 public:
  LittleMemory() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    ::getrlimit(RLIMIT_AS, &before_);
    rlimit limit = before_;
    limit.rlim_cur = pages * static_cast<std::size_t>(::getpagesize()) + (std::size_t{1} << 28);
    ::setrlimit(RLIMIT_AS, &limit);
  }
  ~LittleMemory() { ::setrlimit(RLIMIT_AS, &before_); }
  LittleMemory(const LittleMemory&) = delete;
  LittleMemory& operator=(const LittleMemory&) = delete;

 private:
  rlimit before_{};
};

bool has_limits_of_addresses() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return false;  // a sanitizer takes all addresses at its start
#else
  return true;
#endif
}

TEST(Bands, OfImpossibleSizesAreRefusedBeforeMemoryIsTaken) {
  constexpr std::int32_t kMost = 2'147'483'647;
  std::optional<LittleMemory> limit;
  if (has_limits_of_addresses()) limit.emplace();
  for (const auto& box : std::vector<std::vector<std::int32_t>>{{0, 3, 2'000'000, 40},
                                                                {0, 3, 3, kMost - 1},
                                                                {0, 3, 3, 500'000},
                                                                {-kMost, 3, kMost, 5},
                                                                {0, 3, kMost - 1, kMost - 1},
                                                                {3, 3, 0, 5}}) {
    auto exr = band_file();
    set_box(exr, "displayWindow", {0, 0, 999'999'999, 999'999'999});
    set_box(exr, "dataWindow", box);
    EXPECT_FALSE(decode_band(exr).has_value()) << box[2] << " " << box[3];
    EXPECT_FALSE(mark_of_exr(exr).is_whole) << box[2] << " " << box[3];
  }
}

}  // namespace
}  // namespace aerostat::image
