// A library of the tests that makes a folder behave as one on a poor disk or over a network. It is
// loaded by LD_PRELOAD and changes the calls on files of one folder. Environment variables say how:
//
//   POOR_DISK_FOLDER       the folder; files of folders below it count, too
//   POOR_DISK_SYNC_MS      fsync takes so many milliseconds longer
//   POOR_DISK_SYNC_MARK    a file that is created when the first slow fsync begins
//   POOR_DISK_SYNC_ERROR   fsync fails with this errno
//   POOR_DISK_CLOSE_ERROR  close fails with this errno on files that were synchronised
//   POOR_DISK_QUOTA        a file has room for so many bytes, and then write fails with EDQUOT
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <string>
#include <string_view>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

std::atomic<int> synchronised{-1};

const char* text_of(const char* name) {
  const char* const text = std::getenv(name);
  return text != nullptr ? text : "";
}

/// Returns the number that a variable holds, or 0.
std::uint64_t number_of(const char* name) {
  return std::strtoull(text_of(name), nullptr, 10);
}

/// Returns the function of the system's library that this one stands in front of.
template <typename F>
F next(const char* name) {
  return reinterpret_cast<F>(::dlsym(RTLD_NEXT, name));
}

bool is_poor(int file) {
  const std::string_view folder = text_of("POOR_DISK_FOLDER");
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  std::array<char, 4096> path{};
  const ssize_t length = ::readlink(link.c_str(), path.data(), path.size());
  if (folder.empty() || length < 0) return false;
  return std::string_view(path.data(), static_cast<std::size_t>(length)).starts_with(folder);
}

void wait_ms(std::uint64_t milliseconds) {
  timespec left{static_cast<time_t>(milliseconds / 1000),
                static_cast<long>(milliseconds % 1000 * 1'000'000)};
  while (::nanosleep(&left, &left) != 0 && errno == EINTR) {
  }
}

}  // namespace

#define AEROSTAT_POOR_API extern "C" __attribute__((visibility("default")))

AEROSTAT_POOR_API int fsync(int file) {
  static const auto kReal = next<int (*)(int)>("fsync");
  if (!is_poor(file)) return kReal(file);
  synchronised = file;
  if (const std::uint64_t milliseconds = number_of("POOR_DISK_SYNC_MS"); milliseconds > 0) {
    const char* const mark = text_of("POOR_DISK_SYNC_MARK");
    if (const int made = ::open(mark, O_CREAT | O_WRONLY | O_CLOEXEC, 0600); made >= 0) {
      ::close(made);
    }
    wait_ms(milliseconds);
  }
  if (const auto error = static_cast<int>(number_of("POOR_DISK_SYNC_ERROR")); error != 0) {
    errno = error;
    return -1;
  }
  return kReal(file);
}

AEROSTAT_POOR_API int close(int file) {
  static const auto kReal = next<int (*)(int)>("close");
  const auto error = static_cast<int>(number_of("POOR_DISK_CLOSE_ERROR"));
  const bool fails = error != 0 && file == synchronised && is_poor(file);
  const int result = kReal(file);
  if (!fails || result != 0) return result;
  synchronised = -1;
  errno = error;
  return -1;
}

AEROSTAT_POOR_API ssize_t write(int file, const void* bytes, std::size_t count) {
  static const auto kReal = next<ssize_t (*)(int, const void*, std::size_t)>("write");
  const std::uint64_t quota = number_of("POOR_DISK_QUOTA");
  if (quota == 0 || !is_poor(file)) return kReal(file, bytes, count);
  struct stat status {};
  const std::uint64_t before =
      ::fstat(file, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
  if (before + count <= quota) return kReal(file, bytes, count);
  if (before < quota) return kReal(file, bytes, quota - before);
  errno = EDQUOT;
  return -1;
}
