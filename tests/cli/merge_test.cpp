// Tests pictures in bands, and that joined bands are what one render writes.

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

namespace fs = std::filesystem;

class Merge : public CliTest {
 protected:
  /// Returns arguments that render a small picture with several samples, whose number adapts.
  static std::vector<std::string> picture(const std::string& output,
                                          const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{
        "render", scene_path("sand"), "-o", output,  "--quality", "final", "--width",
        "48",     "--height",         "37", "--spp", "32"};
    for (const char* change : {"/terrain/cells=32", "/vegetation/enabled=false",
                               "/image/vignette=0.4", "/image/adaptive_threshold=0.02"}) {
      arguments.insert(arguments.end(), {"--set", change});
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  void render(const std::string& output, const std::vector<std::string>& more = {}) const {
    const Outcome outcome = run(picture(output, more));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }

  /// Renders the picture in bands, the files 1.exr, 2.exr and so on.
  void render_bands(int count, const std::vector<std::string>& more = {}) const {
    for (int band = 1; band <= count; ++band) {
      const std::string number = std::to_string(band);
      auto arguments = more;
      arguments.insert(arguments.end(), {"--shard", number + "/" + std::to_string(count)});
      render(number + ".exr", arguments);
    }
  }

  std::string bytes(const std::string& name) const { return read_bytes(folder_ / name); }
};

TEST_F(Merge, BandsBecomeThePictureOfOneRender) {
  render("whole.png");
  render("whole.exr");
  // The bands have 12, 12 and 13 rows: none ends with a block of 16 rows, as the file has them.
  render_bands(3);
  ASSERT_EQ(run({"merge", "3.exr", "1.exr", "2.exr", "-o", "joined.png"}).code, 0);
  const Outcome joined = run({"merge", "2.exr", "1.exr", "3.exr", "-o", "joined.exr"});
  EXPECT_TRUE(contains(joined.err, "wrote joined.exr (48 x 37) from 3 bands"));
  EXPECT_EQ(bytes("joined.png"), bytes("whole.png"));
  EXPECT_EQ(bytes("joined.exr"), bytes("whole.exr"));
  // Bands of other cuts overlap, and rows that are there twice are harmless.
  render("low.exr", {"--shard", "2/2"});
  EXPECT_EQ(run({"merge", "low.exr", "1.exr", "2.exr", "low.exr", "-o", "again.exr"}).code, 0);
  EXPECT_EQ(bytes("again.exr"), bytes("whole.exr"));
}

TEST_F(Merge, AFixedExposureIsKept) {
  const std::vector<std::string> fixed{"--set", "/image/exposure_ev=-1.25", "--set",
                                       "/image/white_balance_k=4300"};
  render("whole.png", fixed);
  render_bands(2, fixed);
  ASSERT_EQ(run({"merge", "1.exr", "2.exr", "-o", "joined.png"}).code, 0);
  EXPECT_EQ(bytes("joined.png"), bytes("whole.png"));
}

TEST_F(Merge, BandsOfAFilmWithAnOpenShutterShowOneMoment) {
  // A still picture shows the scene at rest, and so do its bands.
  render("rest.png");
  const std::vector<std::string> open{"--set", "/film/shutter_angle_deg=180"};
  render("whole.png", open);
  render_bands(2, open);
  ASSERT_EQ(run({"merge", "1.exr", "2.exr", "-o", "joined.png"}).code, 0);
  EXPECT_EQ(bytes("joined.png"), bytes("whole.png"));
  EXPECT_EQ(bytes("whole.png"), bytes("rest.png"));
}

TEST_F(Merge, ABandThatIsThereIsKept) {
  render("1.exr", {"--shard", "1/2"});
  const auto time = fs::last_write_time(folder_ / "1.exr");
  const Outcome kept = run(picture("1.exr", {"--shard", "1/2"}));
  EXPECT_EQ(kept.code, 0);
  EXPECT_TRUE(contains(kept.err, "kept 1.exr"));
  EXPECT_EQ(fs::last_write_time(folder_ / "1.exr"), time);
  // Another band, another scene, and a damaged file are made anew.
  const std::string band = bytes("1.exr");
  EXPECT_FALSE(contains(run(picture("1.exr", {"--shard", "2/2"})).err, "kept"));
  EXPECT_NE(bytes("1.exr"), band);
  EXPECT_FALSE(contains(run(picture("1.exr", {"--shard", "1/2", "--seed", "5"})).err, "kept"));
  EXPECT_NE(bytes("1.exr"), band);
  std::ofstream(folder_ / "1.exr") << band.substr(0, band.size() - 100);
  EXPECT_FALSE(contains(run(picture("1.exr", {"--shard", "1/2"})).err, "kept"));
  EXPECT_EQ(bytes("1.exr"), band);
}

TEST_F(Merge, WhatIsWrongIsToldAndNothingIsWritten) {
  render_bands(3);
  render("other.exr", {"--shard", "2/3", "--seed", "5"});
  render("plain.exr");
  std::ofstream(folder_ / "cut.exr") << bytes("2.exr").substr(0, 2000);
  const auto before = files();
  const Outcome missing = run({"merge", "1.exr", "3.exr", "-o", "x.png"});
  EXPECT_EQ(missing.code, 65);
  EXPECT_TRUE(contains(missing.err, "the rows 12 to 23 are missing"));
  const Outcome bottom = run({"merge", "1.exr", "2.exr", "-o", "x.png"});
  EXPECT_TRUE(contains(bottom.err, "the rows 24 to 36 are missing"));
  const Outcome foreign = run({"merge", "1.exr", "other.exr", "3.exr", "-o", "x.exr"});
  EXPECT_EQ(foreign.code, 65);
  EXPECT_TRUE(contains(foreign.err, "'other.exr' and '1.exr' were made from different scenes"));
  const Outcome damaged = run({"merge", "1.exr", "cut.exr", "plain.exr", "3.exr", "-o", "x.exr"});
  EXPECT_EQ(damaged.code, 65);
  EXPECT_TRUE(contains(damaged.err, "'cut.exr' is damaged"));
  EXPECT_TRUE(contains(damaged.err, "'plain.exr' is damaged, or no band"));
  EXPECT_EQ(run({"merge", "1.exr", "no.exr", "-o", "x.exr"}).code, 74);
  EXPECT_EQ(files(), before);
}

TEST_F(Merge, MistakesAreOneClearLineAndCode64) {
  const std::pair<std::vector<std::string>, std::string> mistakes[] = {
      {picture("a.png", {"--shard", "1/2"}), "--shard: a band goes to an .exr file"},
      {picture("a.exr", {"--shard", "1/38"}), "the picture has 37 rows"},
      {picture("a.exr", {"--shard", "3/2"}), "--shard: found '3/2'"},
      {picture("a.exr", {"--shard", "1/2", "--time-limit", "9s"}),
       "--shard: a band has all of its"},
      {picture("a.exr", {"--shard", "1/2", "--crop", "0,0,9,9"}), "--crop"},
      {picture("a.exr", {"--shard", "1/2", "--world-file"}),
       "--world-file needs the whole picture"},
      {{"merge", "a.exr", "-o", "x.tif"}, "expected a .png or .exr"},
      {{"merge", "a.exr", "-o", "-"}, "expected a .png or .exr"},
      {{"merge", "-o", "x.png"}, "FILE"},
  };
  for (const auto& [arguments, part] : mistakes) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 64) << part;
    EXPECT_TRUE(contains(outcome.err, part));
    EXPECT_EQ(files(), std::vector<std::string>{});
  }
}

}  // namespace
}  // namespace aerostat::test
