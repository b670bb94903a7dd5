// Tests where PoCL's compiled kernels are kept.
#include "opencl/cache.hpp"

#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::opencl {
namespace {

namespace fs = std::filesystem;

class Cache : public testing::Test {
 protected:
  static unsigned mode_of(const fs::path& path) {
    struct stat status = {};
    EXPECT_EQ(stat(path.c_str(), &status), 0) << path;
    return status.st_mode & 0777;
  }

  /// Returns a path below a plain file, where nobody can make a folder, not even root.
  fs::path impossible() const {
    std::ofstream(root_ / "file") << "x";
    return root_ / "file" / "below";
  }

  const test::TemporaryFolder folder_;
  const fs::path root_ = folder_.path();
};

TEST_F(Cache, PrefersXdgThenHome) {
  CacheEnvironment environment;
  EXPECT_FALSE(preferred_cache_path(environment));
  environment.home = "/home/u";
  EXPECT_EQ(preferred_cache_path(environment), fs::path("/home/u/.cache/aerostat/pocl"));
  environment.xdg_cache_home = "/var/x";
  EXPECT_EQ(preferred_cache_path(environment), fs::path("/var/x/aerostat/pocl"));
  environment.xdg_cache_home = "relative";
  EXPECT_EQ(preferred_cache_path(environment), fs::path("/home/u/.cache/aerostat/pocl"));
}

TEST_F(Cache, IsPrivate) {
  CacheEnvironment environment;
  environment.home = root_.string();
  const auto folder = prepare_cache(environment);
  EXPECT_EQ(folder.path, root_ / ".cache" / "aerostat" / "pocl");
  EXPECT_FALSE(folder.temporary);
  EXPECT_TRUE(folder.warning.empty());
  EXPECT_EQ(mode_of(folder.path), 0700u);
  EXPECT_TRUE(fs::is_empty(folder.path)) << "the probe is left behind";

  ASSERT_EQ(chmod(folder.path.c_str(), 0777), 0);
  EXPECT_EQ(prepare_cache(environment).path, folder.path);
  EXPECT_EQ(mode_of(folder.path), 0700u);
}

TEST_F(Cache, FallsBackToATemporaryFolder) {
  CacheEnvironment environment;
  environment.tmpdir = root_.string();
  const auto homeless = prepare_cache(environment);
  EXPECT_TRUE(homeless.temporary);
  EXPECT_FALSE(homeless.warning.empty());
  EXPECT_EQ(homeless.path.parent_path(), root_);
  EXPECT_EQ(mode_of(homeless.path), 0700u);

  environment.home = impossible().string();
  const auto blocked = prepare_cache(environment);
  EXPECT_TRUE(blocked.temporary);
  EXPECT_NE(blocked.path, homeless.path);
  EXPECT_NE(blocked.warning.find("below"), std::string::npos) << blocked.warning;
}

TEST_F(Cache, SaysSoIfThereIsNoPlaceAtAll) {
  CacheEnvironment environment;
  environment.tmpdir = impossible().string();
  try {
    prepare_cache(environment);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::io);
    EXPECT_NE(std::string(error.what()).find("POCL_CACHE_DIR"), std::string::npos);
  }
}

TEST_F(Cache, TakesTheUsersFolderAsItIs) {
  CacheEnvironment environment;
  environment.home = root_.string();
  environment.pocl_cache_dir = (root_ / "mine").string();
  ASSERT_TRUE(fs::create_directory(root_ / "mine"));
  ASSERT_EQ(chmod((root_ / "mine").c_str(), 0755), 0);
  EXPECT_EQ(prepare_cache(environment).path, root_ / "mine");
  EXPECT_EQ(mode_of(root_ / "mine"), 0755u);
  EXPECT_FALSE(fs::exists(root_ / ".cache"));

  environment.pocl_cache_dir = impossible().string();
  try {
    prepare_cache(environment);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::io);
    const std::string message = error.what();
    EXPECT_NE(message.find("POCL_CACHE_DIR"), std::string::npos) << message;
    EXPECT_NE(message.find("below"), std::string::npos) << message;
  }
}

TEST_F(Cache, NeedsFreeSpace) {
  CacheEnvironment environment;
  environment.pocl_cache_dir = root_.string();
  EXPECT_THROW(prepare_cache(environment, std::numeric_limits<std::uint64_t>::max()), Error);
  environment.pocl_cache_dir.reset();
  environment.tmpdir = root_.string();
  EXPECT_THROW(prepare_cache(environment, std::numeric_limits<std::uint64_t>::max()), Error);
  EXPECT_TRUE(fs::is_empty(root_)) << "a folder is left behind";
}

}  // namespace
}  // namespace aerostat::opencl
