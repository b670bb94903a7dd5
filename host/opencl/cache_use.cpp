#include "opencl/cache_use.hpp"

#include <cerrno>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace aerostat::opencl {

CacheUse::CacheUse(const std::filesystem::path& cache, Kind kind,
                   std::chrono::milliseconds patience)
    : file_(::open((cache / "aerostat.lock").c_str(), O_RDONLY | O_CREAT | O_CLOEXEC, 0600)) {
  if (file_ < 0) return;
  const auto until = std::chrono::steady_clock::now() + patience;
  const int wanted = (kind == Kind::shared ? LOCK_SH : LOCK_EX) | LOCK_NB;
  while (::flock(file_, wanted) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) return;
    if (std::chrono::steady_clock::now() >= until) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

CacheUse::~CacheUse() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace aerostat::opencl
