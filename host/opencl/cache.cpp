#include "opencl/cache.hpp"

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "core/environment.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "opencl/cache_check.hpp"

namespace aerostat::opencl {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kPrivate = 0700;

std::string reason_of(int error) {
  return std::generic_category().message(error);
}

/// Creates `path` and the folders above it, all with mode 0700 as the XDG Base Directory
/// Specification asks. Returns why it cannot, or nothing.
std::optional<std::string> make_folders(const fs::path& path) {
  fs::path so_far;
  for (const auto& part : path) {
    so_far /= part;
    if (mkdir(so_far.c_str(), kPrivate) == 0 || errno == EEXIST) continue;
    const int error = errno;
    // The folders above may be closed or read-only although they exist.
    struct stat status = {};
    if (stat(so_far.c_str(), &status) != 0) return reason_of(error);
  }
  return std::nullopt;
}

/// Returns why nothing can be written into `path`, or nothing if it can be written.
std::optional<std::string> write_obstacle(const fs::path& path, std::uint64_t min_free_bytes) {
  struct statvfs space = {};
  if (statvfs(path.c_str(), &space) != 0) return reason_of(errno);
  const std::uint64_t free_bytes = std::uint64_t{space.f_bavail} * space.f_frsize;
  if (free_bytes < min_free_bytes) {
    return fmt::format("only {} MiB are free on its disk, {} are needed", free_bytes >> 20,
                       min_free_bytes >> 20);
  }
  std::string probe = (path / "probe-XXXXXX").string();
  const int file = mkstemp(probe.data());
  if (file < 0) return reason_of(errno);
  const bool written = write(file, "aerostat", 8) == 8;
  const int error = errno;
  close(file);
  unlink(probe.c_str());
  return written ? std::nullopt : std::optional(reason_of(error));
}

/// Makes a folder private, because others could plant code in a folder that they own or may write
/// to. Returns why it cannot, or nothing.
std::optional<std::string> make_private(const fs::path& path) {
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0) return reason_of(errno);
  if (!S_ISDIR(status.st_mode)) return "it is not a folder";
  if (status.st_uid != geteuid()) return "it belongs to another user";
  if ((status.st_mode & 0777) != kPrivate && chmod(path.c_str(), kPrivate) != 0) {
    return reason_of(errno);
  }
  return std::nullopt;
}

/// Removes damaged programs, at which PoCL would fail, and sets the warning of `folder` if there
/// were any. Returns why it cannot, or nothing.
std::optional<std::string> mend(CacheFolder& folder) {
  try {
    const auto removed = remove_damaged_programs(folder.path);
    if (removed > 0) {
      folder.warning = fmt::format(
          "compiled kernels in {} were damaged and have been removed; they are compiled again",
          folder.path.string());
    }
    return std::nullopt;
  } catch (const Error& error) {
    return error.what();
  }
}

std::optional<std::string> usable_as_preferred(CacheFolder& folder, std::uint64_t min_free) {
  if (auto problem = make_private_folder(folder.path)) return problem;
  if (auto problem = write_obstacle(folder.path, min_free)) return problem;
  return mend(folder);
}

CacheFolder users_folder(const fs::path& path, std::uint64_t min_free) {
  CacheFolder folder{path, false, {}};
  auto problem = make_folders(path);
  if (!problem) problem = write_obstacle(path, min_free);
  if (!problem) problem = mend(folder);
  if (!problem) return folder;
  throw Error(ErrorKind::io,
              fmt::format("POCL_CACHE_DIR names {}, where PoCL cannot keep compiled kernels: {}",
                          path.string(), *problem));
}

CacheFolder temporary_folder(const CacheEnvironment& environment, const std::string& cause,
                             std::uint64_t min_free) {
  const fs::path root = environment.tmpdir.value_or("/tmp");
  std::string path = (root / "aerostat-pocl-XXXXXX").string();
  std::optional<std::string> problem;
  if (mkdtemp(path.data()) == nullptr) {
    problem = reason_of(errno);
  } else if ((problem = write_obstacle(path, min_free))) {
    rmdir(path.c_str());
  }
  if (problem) {
    throw Error(ErrorKind::io,
                fmt::format("there is no folder for compiled kernels: {}; {}: {}; set "
                            "POCL_CACHE_DIR to a folder that can be written",
                            cause, root.string(), *problem));
  }
  return {path, true,
          fmt::format("compiled kernels are kept in {} and removed at exit: {}", path, cause)};
}

void remove_at_exit(const fs::path& path) {
  static fs::path folder;
  static pid_t owner = 0;
  folder = path;
  owner = getpid();
  std::atexit([] {
    std::error_code ignored;
    if (getpid() == owner) fs::remove_all(folder, ignored);
  });
}

std::string prepare_process() {
  try {
    const auto folder = prepare_cache(CacheEnvironment::of_process());
    if (!folder.warning.empty()) warn(folder.warning);
    if (folder.temporary) remove_at_exit(folder.path);
    setenv("POCL_CACHE_DIR", folder.path.c_str(), 1);
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

CacheEnvironment CacheEnvironment::of_process() {
  return {environment_variable("POCL_CACHE_DIR"), environment_variable("XDG_CACHE_HOME"),
          environment_variable("HOME"), environment_variable("TMPDIR")};
}

std::optional<fs::path> preferred_cache_path(const CacheEnvironment& environment) {
  const auto absolute = [](const std::optional<std::string>& value) {
    return value && fs::path(*value).is_absolute();
  };
  if (absolute(environment.xdg_cache_home)) {
    return fs::path(*environment.xdg_cache_home) / "aerostat" / "pocl";
  }
  if (absolute(environment.home)) {
    return fs::path(*environment.home) / ".cache" / "aerostat" / "pocl";
  }
  return std::nullopt;
}

CacheFolder prepare_cache(const CacheEnvironment& environment, std::uint64_t min_free_bytes) {
  if (environment.pocl_cache_dir) return users_folder(*environment.pocl_cache_dir, min_free_bytes);
  const auto preferred = preferred_cache_path(environment);
  if (!preferred) {
    return temporary_folder(environment, "neither HOME nor XDG_CACHE_HOME is set", min_free_bytes);
  }
  CacheFolder folder{*preferred, false, {}};
  const auto problem = usable_as_preferred(folder, min_free_bytes);
  if (!problem) return folder;
  return temporary_folder(environment, fmt::format("{}: {}", preferred->string(), *problem),
                          min_free_bytes);
}

std::optional<std::string> make_private_folder(const fs::path& path) {
  auto problem = make_folders(path);
  return problem ? problem : make_private(path);
}

void keep_compiled_kernels() {
  if (!ensure_pocl_cache().empty()) return;
  if (const auto folder = environment_variable("POCL_CACHE_DIR")) seal_programs(*folder);
}

void restore_pocl_cache() {
  if (!ensure_pocl_cache().empty()) return;
  // A folder that cannot be made is told by the driver's failure.
  if (const auto folder = environment_variable("POCL_CACHE_DIR")) make_folders(*folder);
}

std::string ensure_pocl_cache() {
  static const std::string kProblem = prepare_process();
  return kProblem;
}

}  // namespace aerostat::opencl
