// Tests how much memory is left according to made-up files of the system.
#include "core/memory_left.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "support/temporary_folder.hpp"

namespace aerostat {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMiB = 1ull << 20;

class Memory : public testing::Test {
 protected:
  void SetUp() override {
    sources_ = {root_ / "proc", root_ / "cgroup", std::nullopt, std::nullopt};
    write("proc/meminfo", "MemTotal: 2097152 kB\nMemAvailable: 1048576 kB\nSwapFree: 0 kB\n");
    write("proc/self/status", "Name: VmSize\nVmSize:\t  102400 kB\nVmData:\t   51200 kB\n");
  }

  void write(const fs::path& name, const std::string& text) const {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << text;
  }

  void group(const fs::path& name, const char* limit, std::uint64_t limit_mib, const char* usage,
             std::uint64_t usage_mib) const {
    write("cgroup" / name / limit, std::to_string(limit_mib * kMiB) + "\n");
    write("cgroup" / name / usage, std::to_string(usage_mib * kMiB) + "\n");
  }

  std::uint64_t left_mib() const { return memory_left(sources_).bytes / kMiB; }

  const test::TemporaryFolder folder_;
  const fs::path root_ = folder_.path();
  MemorySources sources_;
};

TEST_F(Memory, IsWhatTheMachineHasFree) {
  EXPECT_EQ(left_mib(), 1024u);
  EXPECT_EQ(memory_left(sources_).bound, "the free memory of the machine");
  write("proc/meminfo", "MemAvailable: 1048576 kB\nSwapFree: 1024 kB\n");
  EXPECT_EQ(left_mib(), 1025u);
}

TEST_F(Memory, IsUnboundedWhereNothingIsTold) {
  sources_ = {root_ / "nowhere", root_ / "nowhere", std::nullopt, std::nullopt};
  EXPECT_EQ(memory_left(sources_).bytes, ~std::uint64_t{0});
  EXPECT_EQ(memory_obstacle(sources_), "");
}

TEST_F(Memory, IsBoundByGroupsOfVersion2) {
  write("proc/self/cgroup", "0::/user/job\n");
  write("cgroup/user/job/memory.max", "max\n");
  write("cgroup/user/job/memory.current", std::to_string(100 * kMiB));
  EXPECT_EQ(left_mib(), 1024u);
  group("user/job", "memory.max", 500, "memory.current", 100);
  EXPECT_EQ(left_mib(), 400u);
  EXPECT_EQ(memory_left(sources_).bound, "the limit of its control group (container)");
  group("user/job", "memory.high", 450, "memory.current", 100);
  EXPECT_EQ(left_mib(), 350u) << "above memory.high it is slowed down to a halt";
  write("cgroup/user/job/memory.stat",
        "anon 1\ninactive_file " + std::to_string(30 * kMiB) + "\nactive_file 1\n");
  EXPECT_EQ(left_mib(), 380u) << "file caches are dropped first";
  group("user", "memory.max", 300, "memory.current", 290);
  EXPECT_EQ(left_mib(), 10u) << "a group above it is nearly full";
  group("user", "memory.max", 300, "memory.current", 310);
  EXPECT_EQ(left_mib(), 0u);
}

TEST_F(Memory, IsBoundByGroupsOfVersion1) {
  write("proc/self/cgroup", "9:name=systemd:/\n4:cpu,memory:/docker/id\n0::/\n");
  group("memory/docker/id", "memory.limit_in_bytes", 200, "memory.usage_in_bytes", 50);
  EXPECT_EQ(left_mib(), 150u);
  fs::remove_all(root_ / "cgroup/memory/docker");
  EXPECT_EQ(left_mib(), 1024u);
  group("memory", "memory.limit_in_bytes", 128, "memory.usage_in_bytes", 8);
  EXPECT_EQ(left_mib(), 120u) << "inside a container its group is the root";
}

TEST_F(Memory, IsBoundByGroupsBesideThoseOfVersion1) {
  write("proc/self/cgroup", "4:memory:/\n0::/job\n");
  group("unified/job", "memory.max", 200, "memory.current", 50);
  EXPECT_EQ(left_mib(), 150u);
}

TEST_F(Memory, IsBoundByLimitsOfTheProcess) {
  sources_.address_space = 300 * kMiB;
  EXPECT_EQ(left_mib(), 200u);
  EXPECT_EQ(memory_left(sources_).bound, "the limit of its address space (ulimit -v)");
  sources_.data = 150 * kMiB;
  EXPECT_EQ(left_mib(), 100u);
  EXPECT_EQ(memory_left(sources_).bound, "the limit of its data (ulimit -d)");
}

TEST_F(Memory, IsTooLittleForADriver) {
  EXPECT_EQ(memory_obstacle(sources_), "");
  write("proc/self/cgroup", "0::/job\n");
  group("job", "memory.max", 150, "memory.current", 20);
  EXPECT_EQ(memory_obstacle(sources_),
            "there is not enough memory for an OpenCL driver and its compiler: the limit of its "
            "control group (container) leaves 130 MiB, at least 320 MiB are needed");
  sources_.address_space = 600 * kMiB;
  EXPECT_NE(memory_obstacle(sources_).find("limited to 600 MiB (ulimit -v)"), std::string::npos);
}

}  // namespace
}  // namespace aerostat
