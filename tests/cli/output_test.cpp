// Tests that outputs destroy no file that they must keep.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

namespace fs = std::filesystem;

class Output : public CliTest {
 protected:
  Outcome render(const std::string& scene, const std::string& output) const {
    return run({"render", scene, "--quality", "draft", "--width", "16", "--height", "9", "--spp",
                "1", "--quiet", "-o", output});
  }
};

const std::string kScene =
    R"({"version": 1, "terrain": {"cells": 64}, "vegetation": {"enabled": false}})";

TEST_F(Output, TheSceneFileIsNotOverwrittenByAnyOfItsNames) {
  write("scene.png", kScene);
  fs::create_symlink("scene.png", folder_ / "link.png");
  fs::create_hard_link(folder_ / "scene.png", folder_ / "second.exr");
  fs::create_symlink("scene.png", folder_ / "link.ply");
  fs::create_directory(folder_ / "sub");
  const std::vector<std::vector<std::string>> commands = {
      // The output is scene.png by default.
      {"render", "scene.png"},
      {"render", "scene.png", "-o", "scene.png"},
      {"render", "scene.png", "-o", "./sub/../scene.png"},
      {"render", "scene.png", "-o", (folder_ / "scene.png").string()},
      {"render", "scene.png", "-o", "link.png"},
      {"render", "link.png", "-o", "second.exr"},
      {"contact-sheet", "scene.png", "-o", "link.png"},
      {"export", "scene.png", "-o", "link.ply"}};
  for (const auto& command : commands) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 64) << command.back();
    EXPECT_TRUE(contains(outcome.err, "scene file"));
    EXPECT_EQ(read_bytes(folder_ / "scene.png"), kScene);
  }
}

TEST_F(Output, LinksStayAndTheirTargetsAreWritten) {
  write("scene.json", kScene);
  fs::create_directory(folder_ / "real");
  fs::create_symlink("real/no.png", folder_ / "dl.png");
  ASSERT_EQ(render("scene.json", "dl.png").code, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "dl.png"));
  EXPECT_EQ(png_size(read_bytes(folder_ / "real" / "no.png")), (std::pair{16u, 9u}));
  fs::create_symlink("none/no.png", folder_ / "lost.png");
  const Outcome lost = render("scene.json", "lost.png");
  EXPECT_EQ(lost.code, 74);
  EXPECT_TRUE(contains(lost.err, "none/no.png"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "lost.png"));
}

TEST_F(Output, DevicesStayDevices) {
  write("scene.json", kScene);
  fs::create_symlink("/dev/null", folder_ / "null.png");
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  const int reader = ::open((folder_ / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  for (const std::string output : {"/dev/null", "null.png", "pipe"}) {
    const Outcome outcome = render("scene.json", output);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
  }
  char signature[4] = {};
  EXPECT_EQ(::read(reader, signature, 4), 4);
  EXPECT_EQ(std::string(signature, 4), "\x89PNG");
  ::close(reader);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "null.png"));
  EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
  EXPECT_EQ(run({"render", "scene.json", "-o", "picture"}).code, 64) << "no format";
}

TEST_F(Output, AReadOnlyPictureStays) {
  write("scene.json", kScene);
  write("old.png", "old");
  ASSERT_EQ(::chmod((folder_ / "old.png").c_str(), 0444), 0);
  const Outcome outcome = render("scene.json", "old.png");
  EXPECT_EQ(outcome.code, 74);
  EXPECT_TRUE(contains(outcome.err, "read-only"));
  EXPECT_EQ(read_bytes(folder_ / "old.png"), "old");
}

}  // namespace
}  // namespace aerostat::test
