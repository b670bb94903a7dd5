// Tests tiny contact sheets.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

using ContactSheet = CliTest;

std::vector<std::string> small_sheet(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"contact-sheet", scene_path("snow"),
                                     "--set",         "/terrain/cells=64",
                                     "--set",         "/image/spp=1",
                                     "--tile-width",  "32",
                                     "--set",         "/vegetation/density=0.05"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST_F(ContactSheet, IsWrittenByTheScenesName) {
  const Outcome outcome = run(small_sheet({"--seeds", "3,7-8", "--columns", "2"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(contains(outcome.err, "wrote snow-seeds.png (3 tiles of 32 x 18, 1 spp)"));
  EXPECT_EQ(files(), std::vector<std::string>{"snow-seeds.png"});
  // The sheet has two columns and two rows of 32 x 18 pixels, with labels of 11 pixels and margins
  // of 4.
  EXPECT_EQ(png_size(read_bytes(folder_ / "snow-seeds.png")), (std::pair{76u, 70u}));
}

TEST_F(ContactSheet, DependsOnItsSeedsAloneAndOnTheirOrder) {
  const auto sheet = [this](const std::string& seeds) {
    const Outcome outcome = run(small_sheet({"--seeds", seeds, "--quiet", "-o", "x.png"}));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return read_bytes(folder_ / "x.png");
  };
  EXPECT_EQ(sheet("4-6"), sheet("4,5,6"));
  EXPECT_NE(sheet("4-6"), sheet("4,6,5"));
}

TEST_F(ContactSheet, TilesHaveTheShapeOfThePicture) {
  const Outcome outcome = run(small_sheet({"--seeds", "1", "--set", "/image/width=500", "--set",
                                           "/image/height=1000", "--quality", "draft"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "1 tiles of 32 x 64"));
}

TEST_F(ContactSheet, MistakesAreOneClearLineAndCode64) {
  const std::pair<std::vector<std::string>, std::string> mistakes[] = {
      {{"--seeds", ""}, "--seeds"},
      {{"--seeds", "1,,2"}, "--seeds: '1,,2' is not a list of seeds"},
      {{"--seeds", "9-3"}, "from 9 down to 3"},
      {{"--seeds", "1-1001"}, "more than 1000 seeds"},
      {{"--seeds", "4294967296"}, "'4294967296'"},
      {{"--columns", "0"}, "--columns: Value 0"},
      {{"--tile-width", "0"}, "--tile-width: Value 0"},
      {{"--tile-width", "32768", "--seeds", "1-1000"}, "too large for a PNG"},
      {{"--quality", "best"}, "--quality: best"},
      {{"-o", "x.exr"}, "a contact sheet is a .png, not 'x.exr'"},
      {{"-o", "sheet"}, "'sheet'"},
      {{"--width", "5"}, "--width"},
  };
  for (const auto& [arguments, part] : mistakes) {
    const Outcome outcome = run(small_sheet(arguments));
    EXPECT_EQ(outcome.code, 64) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, part));
  }
  EXPECT_EQ(run({"contact-sheet"}).code, 64);
  EXPECT_EQ(run(small_sheet({"-o", "none/x.png"})).code, 74);
  EXPECT_EQ(run(small_sheet({"--set", "/terrain/seed=no"})).code, 65);
  EXPECT_TRUE(files().empty());
}

TEST_F(ContactSheet, AnInterruptEndsItSoonAndKeepsTheOlderFile) {
  write("snow-seeds.png", "older");
  Process process(small_sheet({"--seeds", "1-1000", "--set", "/image/spp=4000"}), folder_, {});
  std::this_thread::sleep_for(std::chrono::seconds(2));
  const auto sent = std::chrono::steady_clock::now();
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - sent;
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_LT(waited.count(), 5.0);
  EXPECT_EQ(read_bytes(folder_ / "snow-seeds.png"), "older");
  EXPECT_EQ(files(), std::vector<std::string>{"snow-seeds.png"});
}

}  // namespace
}  // namespace aerostat::test
