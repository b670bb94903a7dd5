// Tests that outputs are whole or absent on disks that are slow to synchronise, on disks with
// quotas, and on file systems that tell of a failure late, as those over a network do. The disk is
// tests/poor_disk.

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <sys/stat.h>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

namespace fs = std::filesystem;

using Command = std::vector<std::string>;

class PoorDisk : public CliTest {
 protected:
  Environment disk(const Environment& more) const {
    Environment all{"LD_PRELOAD=" AEROSTAT_POOR_DISK, "POOR_DISK_FOLDER=" + folder_.string()};
    // AddressSanitizer wants to be the first library, which it need not be before this one.
    const char* const options = std::getenv("ASAN_OPTIONS");
    all.push_back(std::string("ASAN_OPTIONS=") + (options != nullptr ? options : "") +
                  ":verify_asan_link_order=0");
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  static Command render(const std::vector<std::string>& more = {}) {
    std::vector<std::string> all{"--spp", "1", "--set", "/vegetation/enabled=false"};
    all.insert(all.end(), more.begin(), more.end());
    return small_render("snow", all);
  }

  /// Starts a render, and returns when it has begun to synchronise its output for 20 s.
  Process start_slow_sync(const Command& command) const {
    const fs::path mark = temporary_mark_.path() / "mark";
    fs::remove(mark);
    Process process(command, folder_,
                    disk({"POOR_DISK_SYNC_MS=20000", "POOR_DISK_SYNC_MARK=" + mark.string()}));
    for (int i = 0; i < 1200 && !fs::exists(mark); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    EXPECT_TRUE(fs::exists(mark));
    return process;
  }

  const TemporaryFolder temporary_mark_;
};

/// Commands that write files of each kind. Each of these files has more than 300 bytes.
std::vector<Command> commands() {
  const Command export_snow{"export", scene_path("snow"), "--set", "/terrain/cells=32"};
  Command obj = export_snow, ply = export_snow;
  obj.insert(obj.end(), {"-o", "x.obj"});
  ply.insert(ply.end(), {"-o", "x.ply"});
  return {small_render("snow", {"--spp", "1", "-o", "x.png"}),
          small_render("snow", {"--spp", "1", "-o", "x.exr"}),
          {"contact-sheet", scene_path("snow"), "--set", "/terrain/cells=32", "--seeds", "1-2",
           "--tile-width", "64", "-o", "x.png"},
          ply,
          obj};
}

TEST_F(PoorDisk, IsWaitedForWhereItIsSlow) {
  ASSERT_EQ(run(render({"-o", "quick.png"})).code, 0);
  const fs::path mark = temporary_mark_.path() / "mark";
  const Outcome slow =
      run(render({"-o", "slow.png"}),
          disk({"POOR_DISK_SYNC_MS=1500", "POOR_DISK_SYNC_MARK=" + mark.string()}));
  EXPECT_EQ(slow.code, 0) << slow.err;
  ASSERT_TRUE(fs::exists(mark)) << "the output is not synchronised";
  // The name of a file is renewed only when its data are on the disk.
  struct stat begun {
  }, placed{};
  ASSERT_EQ(::stat(mark.c_str(), &begun), 0);
  ASSERT_EQ(::stat((folder_ / "slow.png").c_str(), &placed), 0);
  EXPECT_GE(placed.st_ctim.tv_sec - begun.st_ctim.tv_sec, 1);
  EXPECT_TRUE(read_bytes(folder_ / "slow.png") == read_bytes(folder_ / "quick.png"));
}

TEST_F(PoorDisk, KeepsTheOldFileWhenASlowWriteIsEnded) {
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    for (const bool is_new : {true, false}) {
      if (!is_new) write("x.png", "old");
      Process process = start_slow_sync(render({"-o", "x.png"}));
      const auto sent = std::chrono::steady_clock::now();
      process.send(signal);
      EXPECT_EQ(process.wait().code, 128 + signal);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - sent;
      EXPECT_LT(took.count(), 3.0);
      EXPECT_EQ(files(), is_new ? std::vector<std::string>() : std::vector<std::string>{"x.png"});
      EXPECT_EQ(read_bytes(folder_ / "x.png"), is_new ? "" : "old");
      fs::remove(folder_ / "x.png");
    }
  }
}

TEST_F(PoorDisk, SavesAtTheFirstSignalAndEndsAtTheSecond) {
  Process process =
      start_slow_sync(render({"--spp", "64", "--width", "320", "--height", "180", "-o", "x.png",
                              "--checkpoint", "x.checkpoint", "--checkpoint-every", "0.001"}));
  process.send(SIGINT);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const auto sent = std::chrono::steady_clock::now();
  process.send(SIGINT);
  EXPECT_EQ(process.wait().code, 128 + SIGINT);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - sent;
  EXPECT_LT(took.count(), 3.0);
  EXPECT_TRUE(files().empty());
}

TEST_F(PoorDisk, EndsInAMessageAtItsQuota) {
  for (const Command& command : commands()) {
    const std::string name = command.back();
    for (const char* quota : {"1", "300"}) {
      write(name, "old");
      const Outcome outcome = run(command, disk({std::string("POOR_DISK_QUOTA=") + quota}));
      EXPECT_EQ(outcome.code, 74) << name << "\n" << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "aerostat: cannot write '"));
      EXPECT_TRUE(contains(outcome.err, "Disk quota exceeded"));
      EXPECT_EQ(files(), std::vector<std::string>{name});
      EXPECT_EQ(read_bytes(folder_ / name), "old");
      fs::remove(folder_ / name);
    }
  }
}

TEST_F(PoorDisk, MayTellOfAFailureLate) {
  for (const char* call : {"SYNC", "CLOSE"}) {
    const std::string fault = std::string("POOR_DISK_") + call + "_ERROR=" + std::to_string(EDQUOT);
    for (const bool is_new : {true, false}) {
      if (!is_new) write("x.png", "old");
      const Outcome outcome = run(render({"-o", "x.png"}), disk({fault}));
      EXPECT_EQ(outcome.code, 74) << fault << "\n" << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "aerostat: cannot write 'x.png': Disk quota exceeded"));
      EXPECT_EQ(files(), is_new ? std::vector<std::string>() : std::vector<std::string>{"x.png"});
      EXPECT_EQ(read_bytes(folder_ / "x.png"), is_new ? "" : "old");
      fs::remove(folder_ / "x.png");
    }
  }
}

TEST_F(PoorDisk, LetsARenderGoOnWithoutItsCheckpoint) {
  const Outcome outcome = run(render({"--spp", "64", "-o", "x.png", "--checkpoint", "x.checkpoint",
                                      "--checkpoint-every", "0.001"}),
                              disk({"POOR_DISK_QUOTA=20000"}));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "Disk quota exceeded"));
  EXPECT_TRUE(contains(outcome.err, "the render goes on"));
  EXPECT_EQ(png_size(read_bytes(folder_ / "x.png")), (std::pair{32u, 18u}));
}

}  // namespace
}  // namespace aerostat::test
