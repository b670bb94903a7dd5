// Tests that a thread which is confined reaches no other files and no network.
#include "core/confine.hpp"

#include <cerrno>
#include <functional>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "support/temporary_folder.hpp"

namespace aerostat::test {
namespace {

namespace fs = std::filesystem;

/// Runs `work` on a thread of its own, which keeps its limits. Returns whether it could be limited.
bool confined(const std::function<bool()>& limit, const std::function<void()>& work) {
  bool can = false;
  std::thread([&] {
    can = limit();
    if (can) work();
  }).join();
  return can;
}

/// Opens a file and returns 0, or the number of the error.
int error_of_opening(const fs::path& path, int how) {
  const int file = ::open(path.c_str(), how | O_CLOEXEC, 0600);
  if (file < 0) return errno;
  ::close(file);
  return 0;
}

int error_of_socket(int domain, int kind) {
  const int socket = ::socket(domain, kind | SOCK_CLOEXEC, 0);
  if (socket < 0) return errno;
  ::close(socket);
  return 0;
}

TEST(Confine, LeavesTheFilesThatAreNamed) {
  const TemporaryFolder folder;
  for (const char* name : {"read", "write", "other"}) {
    fs::create_directory(folder.path() / name);
    EXPECT_EQ(error_of_opening(folder.path() / name / "file", O_CREAT | O_WRONLY), 0);
  }
  const auto limit = [&] {
    return confine_this_thread(
        {{folder.path() / "read", "/no/such/folder"}, {folder.path() / "write"}});
  };
  const bool can = confined(limit, [&] {
    const fs::path root = folder.path();
    EXPECT_EQ(error_of_opening(root / "read/file", O_RDONLY), 0);
    EXPECT_EQ(error_of_opening(root / "read/file", O_WRONLY), EACCES);
    EXPECT_EQ(error_of_opening(root / "read/new", O_CREAT | O_WRONLY), EACCES);
    EXPECT_EQ(error_of_opening(root / "write/file", O_RDWR | O_TRUNC), 0);
    EXPECT_EQ(error_of_opening(root / "write/new", O_CREAT | O_WRONLY), 0);
    EXPECT_EQ(error_of_opening(root / "other/file", O_RDONLY), EACCES);
    EXPECT_EQ(error_of_opening(root / "other/file", O_WRONLY), EACCES);
    EXPECT_EQ(error_of_opening("/etc/passwd", O_RDONLY), EACCES);
    EXPECT_NE(::unlink((root / "read/file").c_str()), 0);
    EXPECT_NE(::rename((root / "write/file").c_str(), (root / "other/moved").c_str()), 0);
    EXPECT_NE(::truncate((root / "read/file").c_str(), 0), 0);
    if (!can_rename_confined()) return;
    fs::create_directory(root / "write/below");
    EXPECT_EQ(::rename((root / "write/file").c_str(), (root / "write/below/file").c_str()), 0);
  });
  if (!can) GTEST_SKIP() << "this system has no Landlock";
  EXPECT_EQ(error_of_opening(folder.path() / "other/file", O_RDONLY), 0)
      << "other threads are not confined";
}

TEST(Confine, LeavesLocalSocketsAlone) {
  const bool can = confined(refuse_connections, [] {
    EXPECT_EQ(error_of_socket(AF_INET, SOCK_STREAM), EACCES);
    EXPECT_EQ(error_of_socket(AF_INET, SOCK_DGRAM), EACCES);
    EXPECT_EQ(error_of_socket(AF_INET6, SOCK_STREAM), EACCES);
    EXPECT_EQ(error_of_socket(AF_NETLINK, SOCK_RAW), EACCES);
    EXPECT_EQ(error_of_socket(AF_UNIX, SOCK_STREAM), 0);
  });
  if (!can) GTEST_SKIP() << "this system has no seccomp";
  EXPECT_EQ(error_of_socket(AF_INET, SOCK_STREAM), 0) << "other threads are not confined";
}

}  // namespace
}  // namespace aerostat::test
