// Tests compiled programs that outlive the run.
#include "opencl/binaries.hpp"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.hpp"
#include "opencl/buffer.hpp"
#include "opencl/launch.hpp"
#include "support/error_of.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::opencl {
namespace {

namespace fs = std::filesystem;

class Binaries : public testing::Test {
 protected:
  void TearDown() override { unsetenv("AEROSTAT_KERNEL_BINARIES"); }

  static std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    return files;
  }

  const test::TemporaryFolder folder_;
  const fs::path root_ = folder_.path();
};

TEST_F(Binaries, AreFoundByTheirKeys) {
  const BinaryStore store(root_ / "a" / "b");
  EXPECT_FALSE(store.find("one"));
  const std::string binary("\0\n machine code \xff", 17);
  store.keep("one", binary);
  store.keep("two", "other");
  EXPECT_EQ(store.find("one"), binary);
  EXPECT_EQ(BinaryStore(root_ / "a" / "b").find("two"), "other");
  EXPECT_FALSE(store.find("three"));
  store.keep("one", "newer");
  EXPECT_EQ(store.find("one"), "newer");
  store.drop("one");
  EXPECT_FALSE(store.find("one"));
  struct stat status = {};
  ASSERT_EQ(stat((root_ / "a" / "b").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0700u) << "others must not plant code there";
}

TEST_F(Binaries, AreNotTakenWhenDamaged) {
  const BinaryStore store(root_ / "kept");
  const std::string binary(1000, 'x');
  for (const int damage : {0, 1, 2, 3, 4, 5}) {
    store.keep("key", binary);
    const auto file = files_in(root_ / "kept").at(0);
    const auto whole = fs::file_size(file);
    if (damage == 0) fs::resize_file(file, 0);
    if (damage == 1) fs::resize_file(file, whole / 2);
    if (damage == 2) fs::resize_file(file, whole - 1);
    if (damage == 3) std::fstream(file, std::ios::in | std::ios::out).seekp(500) << "garbage";
    if (damage == 4) std::ofstream(file) << std::string(whole, 'g');
    if (damage == 5) {
      fs::remove(file);
      fs::create_directory(file);
    }
    EXPECT_FALSE(store.find("key")) << damage;
    EXPECT_TRUE(files_in(root_ / "kept").empty()) << damage;
    store.keep("key", binary);
    EXPECT_EQ(store.find("key"), binary) << damage;
  }
}

TEST_F(Binaries, OfAnotherKeyAreNotTaken) {
  const BinaryStore store(root_);
  store.keep("one", "code of one");
  const auto one = files_in(root_).at(0);
  store.keep("two", "code of two");
  for (const auto& file : files_in(root_)) {
    if (file != one) fs::copy_file(one, file, fs::copy_options::overwrite_existing);
  }
  EXPECT_FALSE(store.find("two"));
  EXPECT_EQ(store.find("one"), "code of one");
}

TEST_F(Binaries, TakeNoMoreThanTheirShare) {
  const BinaryStore store(root_, 3000);
  const std::string binary(800, 'x');
  for (const char* key : {"a", "b", "c"}) {
    store.keep(key, binary);
    // The times of the files must differ.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_TRUE(store.find("a")) << "now the one that was used last";
  store.keep("d", binary);
  EXPECT_FALSE(store.find("b"));
  for (const char* key : {"a", "c", "d"}) EXPECT_TRUE(store.find(key)) << key;
  store.keep("large", std::string(4000, 'x'));
  EXPECT_FALSE(store.find("large"));
}

TEST_F(Binaries, NeedNoFolder) {
  std::ofstream(root_ / "file") << "x";
  for (const auto& folder : {std::optional<fs::path>(), std::optional(root_ / "file" / "below")}) {
    const BinaryStore store(folder);
    store.keep("key", "binary");
    EXPECT_FALSE(store.find("key"));
    store.drop("key");
  }
}

TEST_F(Binaries, AreKeptForDriversThatKeepNone) {
  EXPECT_FALSE(keeps_binaries("Portable Computing Language"));
  EXPECT_FALSE(keeps_binaries("NVIDIA CUDA"));
  EXPECT_FALSE(keeps_binaries("rusticl"));
  EXPECT_TRUE(keeps_binaries("Intel(R) OpenCL"));
  EXPECT_TRUE(keeps_binaries("AMD Accelerated Parallel Processing"));
  setenv("AEROSTAT_KERNEL_BINARIES", "on", 1);
  EXPECT_TRUE(keeps_binaries("rusticl"));
  setenv("AEROSTAT_KERNEL_BINARIES", "off", 1);
  EXPECT_FALSE(keeps_binaries("Intel(R) OpenCL"));
  setenv("AEROSTAT_KERNEL_BINARIES", "perhaps", 1);
  const auto error = test::error_of([] { keeps_binaries("rusticl"); });
  EXPECT_EQ(error.kind(), ErrorKind::usage);
  EXPECT_NE(std::string(error.what()).find("AEROSTAT_KERNEL_BINARIES"), std::string::npos);
}

TEST_F(Binaries, HaveKeysOfAllThatMatters) {
  Device device;
  device.platform = "Platform";
  device.name = "Device";
  device.driver = "1.0";
  const auto key = binary_key(device, "text", "-O");
  EXPECT_EQ(binary_key(device, "text", "-O"), key);
  EXPECT_NE(binary_key(device, "texT", "-O"), key);
  EXPECT_NE(binary_key(device, "text", "-P"), key);
  for (std::string Device::*const field :
       {&Device::platform, &Device::platform_version, &Device::name, &Device::driver}) {
    Device other = device;
    other.*field += "x";
    EXPECT_NE(binary_key(other, "text", "-O"), key);
  }
}

TEST_F(Binaries, ServePrograms) {
  setenv("AEROSTAT_KERNEL_BINARIES", "on", 1);
  const char* const former = std::getenv("XDG_CACHE_HOME");
  const std::string kept_home = former != nullptr ? former : "";
  // The driver has set up its own cache already. Only the folder beside it changes.
  const Context context(select_device(effective_selector("")));
  setenv("XDG_CACHE_HOME", root_.c_str(), 1);
  const SourceTree tree{{"a.cl", "kernel void give(global int* out, int v) { out[0] = v; }\n"}};
  const auto answer = [&](int value) {
    auto kernel = Program(context, tree, "a.cl", 1).kernel("give");
    const Buffer<int> out(context, {}, 1, "the answer");
    launch(context, kernel, 1, out, value);
    return out.read().at(0);
  };
  const fs::path folder = root_ / "aerostat" / "binaries";
  EXPECT_EQ(answer(1), 1);
  ASSERT_EQ(files_in(folder).size(), 1u);
  const auto file = files_in(folder).at(0);
  const auto first = fs::last_write_time(file);
  EXPECT_EQ(answer(2), 2);
  EXPECT_EQ(files_in(folder).size(), 1u);
  EXPECT_GE(fs::last_write_time(file), first) << "the time of its last use";
  fs::resize_file(file, 100);
  EXPECT_EQ(answer(3), 3) << "the damaged one is replaced";
  EXPECT_GT(fs::file_size(file), 100u);
  // The file is whole, but the driver does not accept its content.
  const auto options = build_options(1);
  const auto key = binary_key(context.device(), flatten(tree, "a.cl"), options);
  BinaryStore::of_user().keep(key, "no binary of any driver");
  EXPECT_EQ(answer(4), 4) << "the refused one is replaced";
  EXPECT_NE(BinaryStore::of_user().find(key), "no binary of any driver");
  former != nullptr ? setenv("XDG_CACHE_HOME", kept_home.c_str(), 1) : unsetenv("XDG_CACHE_HOME");
}

}  // namespace
}  // namespace aerostat::opencl
