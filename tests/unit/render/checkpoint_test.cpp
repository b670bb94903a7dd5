// Tests the files of checkpoints: what is written is read, and anything else is refused by name.
#include "render/checkpoint.hpp"

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include <gtest/gtest.h>

#include "support/error_of.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::render {
namespace {

using test::error_of;

const Traits kTraits{{"version of aerostat", "1.2"}, {"size", "5 x 4"}, {"seed", "7"}};
constexpr Crop kWindow{2, 1, 7, 5};
constexpr int kSamples = 64;

FilmSums sums_of(bool with_guides) {
  FilmSums sums;
  sums.window = kWindow;
  sums.samples_done = 16;
  sums.waiting = {{1, 2}, {4, 5}};
  sums.metered_ev = -1.25;
  for (std::size_t i = 0; i < kWindow.pixels(); ++i) {
    const auto value = static_cast<float>(i);
    sums.pixels.push_back({{value, 2.0f * value, std::numeric_limits<float>::quiet_NaN()},
                           16.0f,
                           std::numeric_limits<float>::infinity(),
                           3,
                           17,
                           i % 2 == 0 ? 1u : 0u,
                           0.5f,
                           value});
    if (with_guides) sums.guides.push_back({{value, 0.1f, 0.2f}, {0.0f, 1.0f, 0.0f}});
  }
  return sums;
}

class Checkpoint : public testing::TestWithParam<bool> {
 protected:
  bool has_guides() const { return GetParam(); }

  std::optional<FilmSums> read(const Traits& traits = kTraits) const {
    return read_checkpoint(file_, traits, kWindow, kSamples, has_guides());
  }

  std::string bytes() const {
    std::ifstream file(file_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  void put(const std::string& bytes) const {
    std::ofstream(file_, std::ios::binary | std::ios::trunc) << bytes;
  }

  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "x.checkpoint";
};

INSTANTIATE_TEST_SUITE_P(Guides, Checkpoint, testing::Bool());

TEST_P(Checkpoint, IsReadAsItWasWritten) {
  EXPECT_FALSE(read()) << "there is no file yet";
  const FilmSums sums = sums_of(has_guides());
  write_checkpoint(file_, kTraits, sums);
  const auto back = read();
  ASSERT_TRUE(back);
  EXPECT_EQ(back->samples_done, 16);
  EXPECT_EQ(back->metered_ev, -1.25);
  ASSERT_EQ(back->waiting.size(), 2u);
  EXPECT_EQ(back->waiting[1].y0, 4);
  EXPECT_EQ(back->waiting[1].y1, 5);
  ASSERT_EQ(back->pixels.size(), sums.pixels.size());
  EXPECT_EQ(std::memcmp(back->pixels.data(), sums.pixels.data(), 40 * sums.pixels.size()), 0);
  ASSERT_EQ(back->guides.size(), sums.guides.size());
  if (!sums.guides.empty()) {
    EXPECT_EQ(std::memcmp(back->guides.data(), sums.guides.data(), 24 * sums.guides.size()), 0);
  }
}

TEST_P(Checkpoint, OfAnotherRenderIsRefusedByTheFirstTraitThatDiffers) {
  write_checkpoint(file_, kTraits, sums_of(has_guides()));
  for (std::size_t i = 0; i < kTraits.size(); ++i) {
    Traits other = kTraits;
    other[i].value = "something else";
    const Error error = error_of([&] { read(other); });
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    const std::string message = error.what();
    EXPECT_NE(message.find("of another " + kTraits[i].name + ": found " + kTraits[i].value +
                           ", expected something else"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find(file_.string()), std::string::npos) << message;
  }
}

TEST_P(Checkpoint, IsRefusedIfAnyBitOfItIsDamaged) {
  write_checkpoint(file_, kTraits, sums_of(has_guides()));
  const std::string whole = bytes();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
    put(damaged);
    EXPECT_EQ(error_of([&] { read(); }).kind(), ErrorKind::bad_data) << "byte " << at;
  }
}

TEST_P(Checkpoint, IsRefusedIfItEndsTooSoonOrTooLate) {
  write_checkpoint(file_, kTraits, sums_of(has_guides()));
  const std::string whole = bytes();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    put(whole.substr(0, size));
    EXPECT_EQ(error_of([&] { read(); }).kind(), ErrorKind::bad_data) << size << " bytes";
  }
  put(whole + "x");
  EXPECT_EQ(error_of([&] { read(); }).kind(), ErrorKind::bad_data);
  put("P6 1 1 255 a picture of something else");
  EXPECT_NE(std::string(error_of([&] { read(); }).what()).find("no checkpoint"), std::string::npos);
  put("aerostat checkpoint 2\n and what comes with it");
  EXPECT_NE(std::string(error_of([&] { read(); }).what()).find("another version"),
            std::string::npos);
}

TEST_P(Checkpoint, WithImpossibleSumsIsRefused) {
  const auto refused = [&](auto&& change) {
    FilmSums sums = sums_of(has_guides());
    change(sums);
    write_checkpoint(file_, kTraits, sums);
    return error_of([&] { read(); }).kind() == ErrorKind::bad_data;
  };
  EXPECT_TRUE(refused([](FilmSums& sums) { sums.pixels[3].samples = kSamples + 1; }));
  EXPECT_TRUE(refused([](FilmSums& sums) { sums.pixels[3].coverage = std::nanf(""); }));
  EXPECT_TRUE(refused([](FilmSums& sums) { sums.pixels[3].coverage = 1e30f; }));
  EXPECT_TRUE(refused([](FilmSums& sums) { sums.pixels[3].converged = 2; }));
  EXPECT_TRUE(refused([](FilmSums& sums) { sums.metered_ev = std::nan(""); }));
  EXPECT_TRUE(refused([](FilmSums& sums) { sums.samples_done = kSamples; }));
  EXPECT_TRUE(refused([](FilmSums& sums) { sums.samples_done = -1; }));
  EXPECT_TRUE(refused([](FilmSums& sums) { sums.waiting = {{0, 2}}; }));
  EXPECT_TRUE(refused([](FilmSums& sums) { sums.waiting = {{4, 6}}; }));
  EXPECT_TRUE(refused([](FilmSums& sums) { sums.waiting = {{3, 4}, {1, 2}}; }));
  EXPECT_TRUE(refused([](FilmSums& sums) { sums.window.x0 = 3; }));
}

TEST_P(Checkpoint, OfOtherLayersIsRefused) {
  write_checkpoint(file_, kTraits, sums_of(!has_guides()));
  EXPECT_EQ(error_of([&] { read(); }).kind(), ErrorKind::bad_data);
}

TEST_P(Checkpoint, ThatIsAFolderIsRefused) {
  std::filesystem::create_directory(file_);
  EXPECT_EQ(error_of([&] { read(); }).kind(), ErrorKind::bad_data);
}

}  // namespace
}  // namespace aerostat::render
