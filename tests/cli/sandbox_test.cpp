// Tests that a command in a sandbox does its work, and that it reaches nothing else.
#include <thread>

#include "core/confine.hpp"
#include "run_process.hpp"

namespace aerostat::test {
namespace {

namespace fs = std::filesystem;

class Sandbox : public CliTest {
 protected:
  void SetUp() override {
    if (!can_rename_confined()) GTEST_SKIP() << "this system has no Landlock of version 2";
  }

  /// Writes heights, and a scene in the folder "scenes" whose heights are a link to them.
  void put_scene_with_link() const {
    fs::create_directories(folder_ / "scenes");
    std::string heights = "ncols 40\nnrows 40\nxllcenter 500000\nyllcenter 5200000\ncellsize 50\n";
    for (int i = 0; i < 1600; ++i) heights += std::to_string(500 + i % 40) + " ";
    write("heights.asc", heights);
    fs::create_symlink(folder_ / "heights.asc", folder_ / "scenes/heights.asc");
    write("scenes/a.json",
          R"({"version": 1, "terrain": {"source": "heights.asc", "crs": "EPSG:32632"}})");
  }
};

TEST_F(Sandbox, GivesTheSamePicture) {
  ASSERT_EQ(run(small_render("snow", {"-o", "free.png"})).code, 0);
  const std::string picture = read_bytes(folder_ / "free.png");
  fs::create_directory(folder_ / "out");
  for (const char* output : {"in.png", "out/in.png"}) {
    const Outcome outcome = run(small_render("snow", {"-o", output, "--sandbox"}));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(read_bytes(folder_ / output) == picture) << output;
  }
}

TEST_F(Sandbox, CompilesAndKeepsKernels) {
  const Environment empty{"XDG_CACHE_HOME=" + (folder_ / "cache").string(), "POCL_CACHE_DIR"};
  const Outcome first = run(small_render("snow", {"-o", "a.png", "--sandbox"}), empty);
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(first.err.find("not"), std::string::npos) << first.err;
  EXPECT_FALSE(fs::is_empty(folder_ / "cache/aerostat/pocl"));
  const Outcome second = run(small_render("snow", {"-o", "b.png"}), empty);
  ASSERT_EQ(second.code, 0) << second.err;
  EXPECT_EQ(second.err.find("damaged"), std::string::npos) << second.err;
  EXPECT_TRUE(read_bytes(folder_ / "a.png") == read_bytes(folder_ / "b.png"));
}

TEST_F(Sandbox, KeepsLinksFromLeadingOutside) {
  put_scene_with_link();
  EXPECT_EQ(run({"check", "scenes/a.json"}).code, 0) << run({"check", "scenes/a.json"}).err;
  const Outcome outcome = run({"check", "scenes/a.json", "--sandbox"});
  EXPECT_EQ(outcome.code, 74) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "heights.asc"));
  EXPECT_TRUE(contains(outcome.err, "Permission denied"));
  fs::remove(folder_ / "scenes/heights.asc");
  fs::copy_file(folder_ / "heights.asc", folder_ / "scenes/heights.asc");
  const Outcome inside = run({"check", "scenes/a.json", "--sandbox"});
  EXPECT_EQ(inside.code, 0) << inside.err;
}

TEST_F(Sandbox, TakesWhatTheCommandLineNames) {
  fs::create_directories(folder_ / "saved");
  const Outcome outcome =
      run(small_render("snow", {"-o", "-", "--sandbox", "--checkpoint", "saved/x.checkpoint",
                                "--checkpoint-every", "0.001", "--spp", "33"}));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_GT(png_size(outcome.out).first, 0u);
  for (const char* command : {"dump", "check"}) {
    EXPECT_EQ(run({command, scene_path("snow"), "--sandbox"}).code, 0) << command;
  }
  EXPECT_EQ(run({"export", scene_path("snow"), "--set", "/terrain/cells=32", "--sandbox", "-o",
                 "new/world.ply"})
                .code,
            74)
      << "there is no such folder";
  EXPECT_EQ(run({"export", scene_path("snow"), "--set", "/terrain/cells=32", "--sandbox", "-o",
                 "world.ply"})
                .code,
            0);
}

TEST_F(Sandbox, ExcludesPathsElsewhere) {
  const Outcome outcome = run({"check", scene_path("snow"), "--sandbox", "--allow-external-paths"});
  EXPECT_EQ(outcome.code, 64);
  EXPECT_TRUE(contains(outcome.err, "--allow-external-paths excludes --sandbox"));
}

}  // namespace
}  // namespace aerostat::test
