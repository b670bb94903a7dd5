// Tests that damage to PoCL's compiled kernels is found before PoCL reads them.
#include "opencl/cache_check.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <optional>
#include <thread>

#include <elf.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "opencl/cache.hpp"
#include "opencl/cache_use.hpp"
#include "opencl/driver_abort.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::opencl {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "PN/DMMLEJNLHPLFDLFAICCDNBPDLGBMGDKPPDNID";
constexpr const char* kOther = "AA/IFGMFJGKGFPJGAKLIAHDAJBDDEEMIIKOLDGEM";
constexpr const char* kLibrary = "trace/4-1-1-goffs0-smallgrid/trace.so";

/// Returns a library with headers, some code, and the section headers at the end.
std::string library() {
  Elf64_Ehdr head = {};
  std::copy_n(ELFMAG, SELFMAG, head.e_ident);
  head.e_ident[EI_CLASS] = ELFCLASS64;
  head.e_phoff = sizeof head;
  head.e_phnum = 1;
  head.e_phentsize = sizeof(Elf64_Phdr);
  head.e_shoff = 1024;
  head.e_shnum = 3;
  head.e_shentsize = sizeof(Elf64_Shdr);
  std::string bytes(reinterpret_cast<const char*>(&head), sizeof head);
  bytes.resize(1024 + 3 * sizeof(Elf64_Shdr), 'c');
  return bytes;
}

/// Returns bitcode with two blocks, of four words and of two.
std::string bitcode() {
  const std::uint32_t words[] = {0xdec04342u, 0x1435u, 4, 1, 2, 3, 4, 0xc21u, 2, 1, 2};
  return {reinterpret_cast<const char*>(words), sizeof words};
}

std::uintmax_t whole_bytes(const std::string& name) {
  return name == kLibrary ? library().size() : bitcode().size();
}

void write(const fs::path& path, const std::string& bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << bytes;
}

class CacheCheck : public testing::Test {
 protected:
  void SetUp() override { fill(); }

  void fill() const {
    for (const char* program : {kProgram, kOther}) {
      write(cache_ / program / "program.bc", bitcode());
      write(cache_ / program / kLibrary, library());
      write(cache_ / program / "last_accessed", "");
    }
    write(cache_ / "tempfile_CVnfAr", "");
  }

  /// Expects that `damage` to a program is found, sealed or not, and that only this program is
  /// removed.
  void expect_removal(const char* what, const std::function<void(const fs::path&)>& damage) const {
    for (const bool is_sealed : {false, true}) {
      fill();
      if (is_sealed) seal_programs(cache_);
      damage(cache_ / kProgram);
      EXPECT_EQ(remove_damaged_programs(cache_), 1u) << what << ", sealed: " << is_sealed;
      EXPECT_FALSE(fs::exists(fs::symlink_status(cache_ / kProgram))) << what;
      EXPECT_TRUE(fs::exists(cache_ / kOther / kLibrary)) << what;
      EXPECT_EQ(remove_damaged_programs(cache_), 0u) << what;
    }
  }

  const test::TemporaryFolder folder_;
  const fs::path cache_ = folder_.path();
};

TEST_F(CacheCheck, KeepsWhatIsWhole) {
  EXPECT_EQ(remove_damaged_programs(cache_), 0u);
  seal_programs(cache_);
  EXPECT_EQ(remove_damaged_programs(cache_), 0u);
  for (const char* name : {"program.bc", kLibrary, "last_accessed", "aerostat.seal"}) {
    EXPECT_TRUE(fs::exists(cache_ / kProgram / name)) << name;
  }
  EXPECT_EQ(remove_damaged_programs(cache_ / "nowhere"), 0u);
}

TEST_F(CacheCheck, FindsFilesThatAreCutOff) {
  for (const char* name : {"program.bc", kLibrary}) {
    const std::uintmax_t whole = whole_bytes(name);
    for (const auto bytes :
         {std::uintmax_t{0}, std::uintmax_t{4}, whole / 2, whole - 4, whole - 1}) {
      expect_removal(name,
                     [&](const fs::path& program) { fs::resize_file(program / name, bytes); });
    }
  }
}

TEST_F(CacheCheck, FindsFilesOfAnotherKind) {
  for (const char* name : {"program.bc", kLibrary}) {
    const std::uintmax_t whole = whole_bytes(name);
    expect_removal(
        name, [&](const fs::path& program) { write(program / name, std::string(whole, 'x')); });
    expect_removal(
        name, [&](const fs::path& program) { write(program / name, std::string(whole, '\0')); });
    expect_removal(name, [&](const fs::path& program) {
      fs::remove(program / name);
      fs::create_directory(program / name);
    });
    expect_removal(name, [&](const fs::path& program) {
      fs::remove(program / name);
      fs::create_symlink("/nowhere", program / name);
    });
    expect_removal(name, [&](const fs::path& program) {
      fs::remove(program / name);
      ASSERT_EQ(mkfifo((program / name).c_str(), 0600), 0);
    });
  }
}

TEST_F(CacheCheck, FindsFilesInPlaceOfFolders) {
  for (const char* name : {"trace/4-1-1-goffs0-smallgrid", "trace", "."}) {
    expect_removal(name, [&](const fs::path& program) {
      const fs::path path = (program / name).lexically_normal();
      const fs::path folder = path.has_filename() ? path : path.parent_path();
      fs::remove_all(folder);
      write(folder, "");
    });
  }
  fs::remove_all(cache_ / "PN");
  write(cache_ / "PN", "");
  EXPECT_EQ(remove_damaged_programs(cache_), 1u);
  EXPECT_FALSE(fs::exists(cache_ / "PN"));
}

TEST_F(CacheCheck, FindsChangedBytesBySeals) {
  for (const char* name : {"program.bc", kLibrary}) {
    fill();
    seal_programs(cache_);
    const fs::path file = cache_ / kProgram / name;
    std::fstream(file, std::ios::binary | std::ios::in | std::ios::out).seekp(20) << "garbage";
    EXPECT_EQ(remove_damaged_programs(cache_), 1u) << name;
    EXPECT_FALSE(fs::exists(file));
  }
}

TEST_F(CacheCheck, FindsDamagedSeals) {
  for (const char* bytes : {"", "aerostat seal 1\n", "garbage", "aerostat seal 1\n1 2 3\n0\n"}) {
    expect_removal("seal",
                   [&](const fs::path& program) { write(program / "aerostat.seal", bytes); });
  }
  expect_removal("seal", [&](const fs::path& program) {
    fs::remove(program / "aerostat.seal");
    fs::create_directory(program / "aerostat.seal");
  });
}

TEST_F(CacheCheck, LetsProgramsBeCopied) {
  seal_programs(cache_);
  const fs::path copy = cache_ / "copy";
  fs::create_directory(copy);
  fs::copy(cache_ / "PN", copy / "PN", fs::copy_options::recursive);
  EXPECT_EQ(remove_damaged_programs(copy), 0u);
  std::fstream(copy / kProgram / kLibrary, std::ios::in | std::ios::out).seekp(500) << "d";
  EXPECT_EQ(remove_damaged_programs(copy), 1u);
}

TEST_F(CacheCheck, SealsWhatWasCompiledSince) {
  seal_programs(cache_);
  const fs::path file = cache_ / kProgram / "trace/8-1-1-goffs0-smallgrid/trace.so";
  write(file, library());
  seal_programs(cache_);
  EXPECT_EQ(remove_damaged_programs(cache_), 0u);
  std::fstream(file, std::ios::in | std::ios::out).seekp(500) << "d";
  EXPECT_EQ(remove_damaged_programs(cache_), 1u);
}

TEST_F(CacheCheck, LeavesWhatIsNotOfAProgram) {
  write(cache_ / "XYZ", "");
  write(cache_ / "tempfile_x.so", "half a library");
  write(cache_ / "PN" / "README", "");
  write(cache_ / kProgram / "program.bc_abc.temp", "half");
  write(cache_ / kProgram / "build.log", "");
  EXPECT_EQ(remove_damaged_programs(cache_), 0u);
}

TEST_F(CacheCheck, RemovesAllAfterADriverAborted) {
  setenv("POCL_CACHE_DIR", cache_.c_str(), 1);
  const auto abort_while_compiling = [] {
    const DriverAbortGuard guard;
    { const DriverAbortGuard another; }
    std::abort();
  };
  EXPECT_EXIT(abort_while_compiling(), testing::ExitedWithCode(70), cache_.string());
  unsetenv("POCL_CACHE_DIR");
  EXPECT_EQ(remove_damaged_programs(cache_), 2u);
  fill();
  EXPECT_EQ(remove_damaged_programs(cache_), 0u) << "the mark is gone";
}

TEST_F(CacheCheck, WaitsForThoseThatCompile) {
  setenv("POCL_CACHE_DIR", cache_.c_str(), 1);
  std::optional<DriverAbortGuard> compiling(std::in_place);
  unsetenv("POCL_CACHE_DIR");
  EXPECT_EQ(remove_damaged_programs(cache_), 0u) << "there is nothing to wait for";
  write(suspect_mark(cache_), "");
  std::atomic<bool> is_done = false;
  std::thread removal([&] {
    EXPECT_EQ(remove_damaged_programs(cache_), 2u);
    is_done = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_FALSE(is_done);
  EXPECT_TRUE(fs::exists(cache_ / kProgram / kLibrary));
  compiling.reset();
  removal.join();
  EXPECT_FALSE(fs::exists(cache_ / kProgram / kLibrary));
}

TEST(CacheUse, IsSharedOrAlone) {
  const test::TemporaryFolder folder;
  const std::chrono::milliseconds patience(150);
  const auto seconds = [&](CacheUse::Kind kind) {
    const auto began = std::chrono::steady_clock::now();
    const CacheUse use(folder.path(), kind, patience);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  {
    const CacheUse shared(folder.path(), CacheUse::Kind::shared);
    EXPECT_LT(seconds(CacheUse::Kind::shared), 0.15);
    EXPECT_GE(seconds(CacheUse::Kind::alone), 0.15) << "its patience is over";
  }
  const CacheUse alone(folder.path(), CacheUse::Kind::alone);
  EXPECT_GE(seconds(CacheUse::Kind::shared), 0.15);
}

TEST_F(CacheCheck, NamesMemoryIfADriverAbortsInALimitedAddressSpace) {
  setenv("POCL_CACHE_DIR", cache_.c_str(), 1);
  const auto abort_in_little_memory = [] {
    const rlimit limit{1ull << 40, 1ull << 40};
    setrlimit(RLIMIT_AS, &limit);
    const DriverAbortGuard guard;
    std::abort();
  };
  EXPECT_EXIT(abort_in_little_memory(), testing::ExitedWithCode(75), "ulimit -v");
  unsetenv("POCL_CACHE_DIR");
  EXPECT_EQ(remove_damaged_programs(cache_), 0u);
  EXPECT_EXIT(
      {
        { const DriverAbortGuard guard; }
        std::abort();
      },
      testing::KilledBySignal(SIGABRT), "");
}

TEST_F(CacheCheck, SaysWhatItRemoved) {
  CacheEnvironment environment;
  environment.pocl_cache_dir = cache_.string();
  EXPECT_EQ(prepare_cache(environment).warning, "");
  fs::resize_file(cache_ / kProgram / kLibrary, 0);
  const std::string warning = prepare_cache(environment).warning;
  EXPECT_NE(warning.find(cache_.string() + " were damaged"), std::string::npos) << warning;
  EXPECT_FALSE(fs::exists(cache_ / kProgram));
  EXPECT_EQ(prepare_cache(environment).warning, "");
}

}  // namespace
}  // namespace aerostat::opencl
