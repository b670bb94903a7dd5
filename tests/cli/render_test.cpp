// Tests whole, small renders.

#include <chrono>
#include <csignal>
#include <thread>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

using Render = CliTest;

TEST_F(Render, WritesAPngByTheScenesName) {
  const Outcome outcome = run(small_render("snow", {"--spp", "1"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(contains(outcome.err, "snow.png"));
  EXPECT_EQ(files(), std::vector<std::string>{"snow.png"});
  EXPECT_EQ(png_size(read_bytes(folder_ / "snow.png")), (std::pair{32u, 18u}));
}

TEST_F(Render, QuietSaysNothing) {
  const Outcome outcome = run(small_render("sand-empty", {"--spp", "1", "--quiet"}));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
}

TEST_F(Render, TheSameCommandGivesTheSameBytes) {
  ASSERT_EQ(run(small_render("snow", {"--spp", "2", "-o", "a.png"})).code, 0);
  ASSERT_EQ(run(small_render("snow", {"--spp", "2", "-o", "b.png"})).code, 0);
  EXPECT_EQ(read_bytes(folder_ / "a.png"), read_bytes(folder_ / "b.png"));
}

TEST_F(Render, SeveralDevicesGiveThePictureOfOne) {
  const Environment two_units{"POCL_MAX_PTHREAD_COUNT=2"};
  const auto picture = [&](const std::string& devices, const std::string& name) {
    return run(small_render("snow", {"--spp", "20", "-o", name, "--device", devices, "--stats"}),
               two_units);
  };
  const Outcome one = picture("portable", "one.exr"), two = picture("portable/2", "two.exr");
  ASSERT_EQ(one.code, 0) << one.err;
  ASSERT_EQ(two.code, 0) << two.err;
  EXPECT_EQ(read_bytes(folder_ / "one.exr"), read_bytes(folder_ / "two.exr"));
  EXPECT_TRUE(contains(two.err, "/2.0: "));
  EXPECT_TRUE(contains(two.err, "/2.1: "));
  EXPECT_FALSE(contains(one.err, "% of them"));
}

TEST_F(Render, OptionsWinOverSet) {
  const Outcome outcome = run(small_render("sand", {"--set", "/image/width=64", "--spp", "1"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(png_size(read_bytes(folder_ / "sand.png")), (std::pair{32u, 18u}));
}

TEST_F(Render, WritesAnExrWithItsLayers) {
  const Outcome outcome = run(small_render("snow", {"--spp", "1", "-o", "x.exr"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  Imf::InputFile file((folder_ / "x.exr").c_str());
  const auto window = file.header().dataWindow();
  EXPECT_EQ(window.max.x - window.min.x + 1, 32);
  EXPECT_EQ(window.max.y - window.min.y + 1, 18);
  for (const char* name : {"R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z"}) {
    const Imf::Channel* channel = file.header().channels().findChannel(name);
    ASSERT_NE(channel, nullptr) << name;
    EXPECT_EQ(channel->type, Imf::FLOAT) << name;
  }
  const Imf::Channel* id = file.header().channels().findChannel("id");
  ASSERT_NE(id, nullptr);
  EXPECT_EQ(id->type, Imf::UINT);
}

TEST_F(Render, CropsAndReports) {
  const Outcome outcome =
      run(small_render("snow", {"--spp", "1", "--crop", "4,2,20,10", "--stats", "--quiet"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(png_size(read_bytes(folder_ / "snow.png")), (std::pair{16u, 8u}));
  for (const char* word : {"world", "tree", "kernels", "upload", "primary", "shadow", "memory"}) {
    EXPECT_TRUE(contains(outcome.err, word));
  }
}

TEST_F(Render, LeadingZerosAreNoOctalNumbers) {
  const Outcome outcome = run(small_render("snow", {"--spp", "01", "--width", "010"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(png_size(read_bytes(folder_ / "snow.png")), (std::pair{10u, 18u}));
}

TEST_F(Render, DraftsWhereTheSceneSaysNothing) {
  const Outcome draft = run(small_render("snow", {"--quality", "draft", "--stats"}));
  ASSERT_EQ(draft.code, 0) << draft.err;
  EXPECT_TRUE(contains(draft.err, " 1 spp"));
  EXPECT_FALSE(contains(draft.err, "ambient"));
  const Outcome mixed =
      run(small_render("snow", {"--quality", "draft", "--set", "/sky/ambient_occlusion=true",
                                "--spp", "2", "--stats"}));
  ASSERT_EQ(mixed.code, 0) << mixed.err;
  EXPECT_TRUE(contains(mixed.err, " 2 spp"));
  EXPECT_TRUE(contains(mixed.err, "ambient"));
}

TEST_F(Render, RefusesOutputsItCannotWriteBeforeItBegins) {
  const Outcome folder = run(small_render("snow", {"-o", "none/x.png"}));
  EXPECT_EQ(folder.code, 74);
  EXPECT_TRUE(contains(folder.err, "none/x.png"));
  const Outcome locked = run(small_render("snow", {"-o", "/proc/x.png"}));
  EXPECT_EQ(locked.code, 74);
  EXPECT_TRUE(contains(locked.err, "/proc/x.png"));
  std::filesystem::create_directory(folder_ / "dir.png");
  EXPECT_EQ(run(small_render("snow", {"-o", "dir.png"})).code, 64);
  EXPECT_EQ(files(), std::vector<std::string>{"dir.png"});
}

TEST_F(Render, AFullDiskIsAnError) {
  std::filesystem::create_symlink("/dev/full", folder_ / "full.png");
  const Outcome outcome = run(small_render("snow", {"--spp", "1", "-o", "full.png"}));
  EXPECT_EQ(outcome.code, 74);
  EXPECT_TRUE(contains(outcome.err, "full.png"));
}

TEST_F(Render, AnInterruptEndsItSoonAndKeepsTheOlderFile) {
  write("snow.png", "older");
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}}) {
    // The render has far more samples than it could take before the signal.
    Process process(small_render("snow", {"--width", "2000", "--height", "2000", "--spp", "60000"}),
                    folder_, {});
    std::this_thread::sleep_for(std::chrono::seconds(2));
    const auto sent = std::chrono::steady_clock::now();
    process.send(signal);
    const Outcome outcome = process.wait();
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - sent;
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_LT(waited.count(), 5.0);
    EXPECT_TRUE(contains(outcome.err, "aerostat: "));
    EXPECT_EQ(read_bytes(folder_ / "snow.png"), "older");
    EXPECT_EQ(files(), std::vector<std::string>{"snow.png"});
  }
}

}  // namespace
}  // namespace aerostat::test
