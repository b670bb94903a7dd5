// Tests that files are written completely or not at all.

#include "core/file.hpp"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"
#include "core/leftovers.hpp"
#include "support/error_of.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat {
namespace {

namespace fs = std::filesystem;
using test::error_of;

std::vector<std::uint8_t> bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class WriteFile : public testing::Test {
 protected:
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  const test::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
};

TEST_F(WriteFile, WritesAndReplaces) {
  const fs::path path = folder_ / "a.png";
  write_file(path, bytes_of("first"));
  EXPECT_EQ(read(path), "first");
  write_file(path, bytes_of("the second is longer"));
  EXPECT_EQ(read(path), "the second is longer");
  write_file(path, {});
  EXPECT_EQ(read(path), "");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WriteFile, HonoursTheUmaskAndKeepsAnOlderMode) {
  const mode_t before = ::umask(027);
  write_file(folder_ / "new", bytes_of("x"));
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat((folder_ / "new").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
  ASSERT_EQ(::chmod((folder_ / "new").c_str(), 0604), 0);
  write_file(folder_ / "new", bytes_of("y"));
  ASSERT_EQ(::stat((folder_ / "new").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0604u);
}

TEST_F(WriteFile, WritesThroughALinkAndKeepsIt) {
  write_file(folder_ / "real", bytes_of("old"));
  fs::create_symlink("real", folder_ / "link");
  write_file(folder_ / "link", bytes_of("new"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read(folder_ / "real"), "new");
  EXPECT_EQ(entries(), 2u);
}

TEST_F(WriteFile, WritesWhatALinkPointsToWhereThatIsNotThereYet) {
  fs::create_directory(folder_ / "real");
  fs::create_symlink("real/new.png", folder_ / "link.png");
  fs::create_symlink(folder_ / "link.png", folder_ / "real" / "to link.png");
  const fs::path link = folder_ / "real" / "to link.png";
  require_writable(link);
  EXPECT_FALSE(fs::exists(folder_ / "real" / "new.png"));
  write_file(link, bytes_of("new"));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.png"));
  EXPECT_FALSE(fs::is_symlink(folder_ / "real" / "new.png"));
  EXPECT_EQ(read(folder_ / "real" / "new.png"), "new");
}

TEST_F(WriteFile, NamesTheLinkAndItsTargetWhereThatHasNoFolder) {
  fs::create_symlink("none/new.png", folder_ / "link.png");
  for (const Error& error : {error_of([&] { require_writable(folder_ / "link.png"); }),
                             error_of([&] { write_file(folder_ / "link.png", bytes_of("x")); })}) {
    EXPECT_EQ(error.kind(), ErrorKind::io);
    EXPECT_NE(std::string(error.what()).find("link.png'"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("none/new.png'"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.png"));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WriteFile, LinksThatLeadInACircleAreAnError) {
  fs::create_symlink("b", folder_ / "a");
  fs::create_symlink("a", folder_ / "b");
  EXPECT_EQ(error_of([&] { require_writable(folder_ / "a"); }).kind(), ErrorKind::io);
  EXPECT_EQ(error_of([&] { write_file(folder_ / "a", bytes_of("x")); }).kind(), ErrorKind::io);
  EXPECT_TRUE(fs::is_symlink(folder_ / "a"));
  EXPECT_EQ(entries(), 2u);
}

TEST_F(WriteFile, OtherNamesOfAFileKeepItsOldContent) {
  write_file(folder_ / "a", bytes_of("old"));
  fs::create_hard_link(folder_ / "a", folder_ / "b");
  EXPECT_TRUE(is_same_file(folder_ / "a", folder_ / "b"));
  write_file(folder_ / "a", bytes_of("new"));
  EXPECT_EQ(read(folder_ / "a"), "new");
  EXPECT_EQ(read(folder_ / "b"), "old");
  EXPECT_FALSE(is_same_file(folder_ / "a", folder_ / "b"));
}

TEST_F(WriteFile, LeavesAFileThatIsReadOnly) {
  const fs::path path = folder_ / "a";
  write_file(path, bytes_of("kept"));
  ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
  fs::create_symlink("a", folder_ / "link");
  for (const fs::path& name : {path, folder_ / "link"}) {
    EXPECT_EQ(error_of([&] { require_writable(name); }).kind(), ErrorKind::io);
    const Error error = error_of([&] { write_file(name, bytes_of("lost")); });
    EXPECT_EQ(error.kind(), ErrorKind::io);
    EXPECT_NE(std::string(error.what()).find("read-only"), std::string::npos) << error.what();
  }
  EXPECT_EQ(read(path), "kept");
}

TEST_F(WriteFile, KeepsOwnerAndGroup) {
  const fs::path path = folder_ / "a";
  write_file(path, bytes_of("old"));
  // Only root may give files away.
  if (::chown(path.c_str(), 12345, 23456) != 0) return;
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  write_file(path, bytes_of("new"));
  struct stat status {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, 12345u);
  EXPECT_EQ(status.st_gid, 23456u);
  EXPECT_EQ(status.st_mode & 07777u, 0640u);
}

TEST_F(WriteFile, RemovesWhatKilledRunsLeft) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  // After this call there is no process with this number.
  ::waitpid(child, nullptr, 0);
  const auto name = [this](pid_t process) {
    return folder_ / (".aerostat-" + std::to_string(process) + "-0.tmp");
  };
  const auto put = [](const fs::path& path, int hours) {
    std::ofstream(path) << "half";
    fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  put(name(child), 2);
  put(name(::getppid()), 2);
  put(folder_ / ".aerostat-notes.tmp", 2);
  require_writable(folder_ / "a.png");
  EXPECT_FALSE(fs::exists(name(child)));
  EXPECT_TRUE(fs::exists(name(::getppid()))) << "it may still be written";
  EXPECT_TRUE(fs::exists(folder_ / ".aerostat-notes.tmp"));
  put(name(child), 0);
  require_writable(folder_ / "a.png");
  EXPECT_TRUE(fs::exists(name(child))) << "its process may be of another container";
}

TEST_F(WriteFile, ALeftoverOfThisSystemIsRemovedAtOnce) {
  const auto names = [this] {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      found.push_back(entry.path().filename().string());
    }
    return found;
  };
  const pid_t child = ::fork();
  if (child == 0) {
    std::ofstream(temporary_name(folder_)) << "half";
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  ASSERT_EQ(names().size(), 1u);
  const fs::path own = temporary_name(folder_);
  std::ofstream(own) << "half";
  // A process that got the number of an older one has begun later.
  std::string recycled = own.filename().string();
  recycled.insert(recycled.rfind(".tmp"), "0");
  std::ofstream(folder_ / recycled) << "half";
  require_writable(folder_ / "a.png");
  EXPECT_EQ(names(), std::vector<std::string>{own.filename().string()})
      << "the file of this process may still be written";
}

TEST_F(WriteFile, PartsAreWrittenOneBehindTheOther) {
  const auto first = bytes_of("one "), second = bytes_of("two");
  const std::vector<std::span<const std::uint8_t>> parts{first, {}, second};
  write_file_of(folder_ / "a", parts);
  EXPECT_EQ(read(folder_ / "a"), "one two");
}

TEST_F(WriteFile, OpenFilesAreWrittenToAndNotReplaced) {
  const fs::path path = folder_ / "log";
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  ASSERT_GE(fd, 0);
  ASSERT_EQ(::write(fd, "one ", 4), 4);
  for (const std::string folder : {"/dev/fd/", "/proc/self/fd/"}) {
    const std::string name = folder + std::to_string(fd);
    EXPECT_TRUE(is_special_file(name));
    require_writable(name);
    write_file(name, bytes_of("two "));
  }
  fs::create_symlink("/dev/fd/" + std::to_string(fd), folder_ / "link.png");
  write_file(folder_ / "link.png", bytes_of("three"));
  ::close(fd);
  EXPECT_EQ(read(path), "one two two three");
}

TEST_F(WriteFile, StampsTellReplacedAndChangedFiles) {
  const fs::path path = folder_ / "a";
  EXPECT_FALSE(file_stamp(path).exists());
  write_file(path, bytes_of("1"));
  const FileStamp first = file_stamp(path);
  EXPECT_TRUE(first.exists());
  EXPECT_EQ(file_stamp(path), first);
  // The link keeps the number of the old file from being used again.
  fs::create_hard_link(path, folder_ / "older");
  write_file(path, bytes_of("2"));
  const FileStamp second = file_stamp(path);
  EXPECT_NE(second, first);
  std::ofstream(path, std::ios::app) << "3";
  EXPECT_NE(file_stamp(path), second);
}

TEST_F(WriteFile, ReportsAFullDevice) {
  const Error error = error_of([] { write_file("/dev/full", bytes_of("some bytes")); });
  EXPECT_EQ(error.kind(), ErrorKind::io);
  EXPECT_NE(std::string(error.what()).find("'/dev/full'"), std::string::npos);
  EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos);
}

TEST_F(WriteFile, WritesSpecialFilesDirectly) {
  write_file("/dev/null", bytes_of("gone"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = read(pipe); });
  const std::string sent(1 << 20, 'p');
  write_file(pipe, bytes_of(sent));
  reader.join();
  EXPECT_EQ(received, sent);
}

TEST_F(WriteFile, AnInterruptedWriteKeepsTheOlderFileAndLeavesNothing) {
  const fs::path path = folder_ / "a";
  write_file(path, bytes_of("older"));
  // A limit on file sizes stands in for a disk that fills up during a write.
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::vector<std::uint8_t> large(1 << 20, 7);
  const Error replaced = error_of([&] { write_file(path, large); });
  const Error created = error_of([&] { write_file(folder_ / "b", large); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(replaced.kind(), ErrorKind::io);
  EXPECT_EQ(created.kind(), ErrorKind::io);
  EXPECT_EQ(read(path), "older");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WriteFile, AKilledProcessLeavesNoPart) {
  const int unnamed = ::open(folder_.c_str(), O_WRONLY | O_TMPFILE, 0600);
  if (unnamed < 0) GTEST_SKIP() << "this file system has no unnamed files";
  ::close(unnamed);
  const std::vector<std::uint8_t> large(8 << 20, 7);
  const pid_t child = ::fork();
  if (child == 0) {
    for (;;) {
      write_file(folder_ / "a", large);
      ::unlink((folder_ / "a").c_str());
    }
  }
  ASSERT_GT(child, 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_LE(entries(), 1u);
  if (fs::exists(folder_ / "a")) {
    EXPECT_EQ(fs::file_size(folder_ / "a"), large.size());
  }
}

TEST_F(WriteFile, NeedsAFolder) {
  const fs::path path = folder_ / "none" / "a.png";
  EXPECT_EQ(error_of([&] { require_writable(path); }).kind(), ErrorKind::io);
  EXPECT_EQ(error_of([&] { write_file(path, bytes_of("x")); }).kind(), ErrorKind::io);
  EXPECT_EQ(error_of([&] { require_writable(folder_); }).kind(), ErrorKind::usage);
  EXPECT_EQ(error_of([&] { require_writable(""); }).kind(), ErrorKind::usage);
  EXPECT_EQ(error_of([&] { write_file(folder_, bytes_of("x")); }).kind(), ErrorKind::usage);
  EXPECT_EQ(entries(), 0u);
}

TEST_F(WriteFile, ReportsAFolderThatCannotBeWritten) {
  // Permissions do not restrict root, but nobody can create files in /proc.
  const fs::path locked = ::geteuid() == 0 ? fs::path("/proc") : folder_;
  if (::geteuid() != 0) ::chmod(folder_.c_str(), 0500);
  EXPECT_EQ(error_of([&] { require_writable(locked / "a.png"); }).kind(), ErrorKind::io);
  EXPECT_EQ(error_of([&] { write_file(locked / "a.png", bytes_of("x")); }).kind(), ErrorKind::io);
}

TEST_F(WriteFile, TryingLeavesNothingAndTouchesNothing) {
  require_writable(folder_ / "a.png");
  EXPECT_EQ(entries(), 0u);
  write_file(folder_ / "a.png", bytes_of("kept"));
  require_writable(folder_ / "a.png");
  EXPECT_EQ(read(folder_ / "a.png"), "kept");
  EXPECT_EQ(entries(), 1u);
  require_writable("/dev/null");
  require_writable("/dev/full");
}

}  // namespace
}  // namespace aerostat
