#include "opencl/driver_abort.hpp"

#include <csignal>
#include <mutex>
#include <optional>
#include <string>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "core/environment.hpp"
#include "core/error.hpp"
#include "opencl/cache_check.hpp"
#include "opencl/cache_use.hpp"

namespace aerostat::opencl {
namespace {

/// The data of the signal handler, which may neither allocate nor lock.
struct LastWords {
  std::string message;
  /// The path of the mark that makes the cache suspect. It is empty if the cache is not the cause.
  std::string suspect_path;
  int exit_code = 0;
};

std::mutex mutex;
int guards = 0;
std::optional<CacheUse> cache_use;
struct sigaction former = {};
/// The data of the signal handler. It is never deleted, because a driver may abort after main.
LastWords& last_words = *new LastWords;

extern "C" void tell_and_exit(int) {
  if (!last_words.suspect_path.empty()) {
    const int file = open(last_words.suspect_path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    if (file >= 0) close(file);
  }
  [[maybe_unused]] const auto written =
      write(STDERR_FILENO, last_words.message.data(), last_words.message.size());
  _exit(last_words.exit_code);
}

bool address_space_is_limited() {
  rlimit limit = {};
  return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

LastWords compose() {
  const std::string head =
      "aerostat: the process was aborted while kernels were compiled, most likely by the OpenCL "
      "driver; ";
  if (address_space_is_limited()) {
    return {head +
                "it may need more memory than the limit of the address space (ulimit -v) "
                "allows: raise the limit\n",
            {},
            static_cast<int>(ErrorKind::exhausted)};
  }
  const auto folder = environment_variable("POCL_CACHE_DIR");
  if (!folder) {
    return {head + "its message, if any, is above\n", {}, static_cast<int>(ErrorKind::internal)};
  }
  return {fmt::format("{}the compiled kernels in {} will be removed by the next run, which "
                      "compiles them again\n",
                      head, *folder),
          suspect_mark(*folder).string(), static_cast<int>(ErrorKind::internal)};
}

}  // namespace

DriverAbortGuard::DriverAbortGuard() {
  const std::lock_guard lock(mutex);
  if (guards++ > 0) return;
  if (const auto folder = environment_variable("POCL_CACHE_DIR")) {
    cache_use.emplace(*folder, CacheUse::Kind::shared);
  }
  last_words = compose();
  struct sigaction action = {};
  action.sa_handler = tell_and_exit;
  sigaction(SIGABRT, &action, &former);
}

DriverAbortGuard::~DriverAbortGuard() {
  const std::lock_guard lock(mutex);
  if (--guards > 0) return;
  sigaction(SIGABRT, &former, nullptr);
  cache_use.reset();
}

}  // namespace aerostat::opencl
