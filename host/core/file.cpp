#include "core/file.hpp"

#include <cerrno>
#include <charconv>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.hpp"
#include "core/leftovers.hpp"

namespace aerostat {

namespace {

namespace fs = std::filesystem;

std::string reason(int code) {
  return std::generic_category().message(code);
}

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
  throw Error(ErrorKind::io, fmt::format("cannot write '{}': {}", path.string(), why));
}

/// An open file. The temporary file that it names is removed by the destructor unless keep() was
/// called.
class Descriptor {
 public:
  explicit Descriptor(int fd, fs::path temporary = {})
      : fd_(fd), temporary_(std::move(temporary)) {}
  Descriptor(Descriptor&& other) noexcept
      : fd_(std::exchange(other.fd_, -1)), temporary_(std::exchange(other.temporary_, {})) {}
  Descriptor& operator=(Descriptor&&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }

  int fd() const { return fd_; }
  bool is_named() const { return !temporary_.empty(); }
  const fs::path& temporary() const { return temporary_; }
  void set_temporary(fs::path path) { temporary_ = std::move(path); }
  void keep() { temporary_.clear(); }

  /// Closes the file. Returns 0 if all data were written, else the system's error code.
  int close() { return ::close(std::exchange(fd_, -1)) == 0 ? 0 : errno; }

 private:
  int fd_;
  fs::path temporary_;
};

fs::path folder_of(const fs::path& path) {
  const fs::path parent = path.parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

/// The parts of a file, one behind the other.
using Parts = std::span<const std::span<const std::uint8_t>>;

constexpr mode_t kMode = 0666;  // the process's umask takes bits away

Descriptor create_named(const fs::path& path) {
  remove_leftovers(folder_of(path));
  for (int attempt = 0; attempt < 100; ++attempt) {
    fs::path name = temporary_name(folder_of(path));
    const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kMode);
    if (fd >= 0) return Descriptor(fd, std::move(name));
    if (errno != EEXIST && errno != EINTR) fail(path, reason(errno));
  }
  fail(path, "no free name for a temporary file beside it");
}

std::string handle_of(const Descriptor& file) {
  return fmt::format("/proc/self/fd/{}", file.fd());
}

// Opens a file without a name, which vanishes with the process even if that is killed. Opens a
// named file where the file system has no unnamed ones, or where /proc is missing, which is
// needed to name the file later.
Descriptor create_temporary(const fs::path& path) {
  const int fd = ::open(folder_of(path).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, kMode);
  if (fd < 0) return create_named(path);
  Descriptor file(fd);
  if (::access(handle_of(file).c_str(), F_OK) != 0) return create_named(path);
  return file;
}

void write_all(int fd, Parts parts, const fs::path& path) {
  for (std::span<const std::uint8_t> bytes : parts) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(fd, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) fail(path, reason(written < 0 ? errno : ENOSPC));
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
  }
}

std::optional<struct stat> status_of(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) return status;
  if (errno != ENOENT) fail(path, reason(errno));
  return std::nullopt;
}

/// Returns the number of the open file that a name such as "/dev/stdout" or "/dev/fd/3" stands
/// for. Such a file must not be opened anew, because that would truncate a regular file behind
/// it.
std::optional<int> open_file_of(const fs::path& path) {
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  const std::string folder = path.parent_path().string();
  if (folder != "/dev/fd" && folder != "/proc/self/fd") return std::nullopt;
  const std::string name = path.filename().string();
  int number = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error != std::errc{} || end != name.data() + name.size() || number < 0) return std::nullopt;
  return number;
}

constexpr int kMostLinks = 40;  // the kernel's own limit

// Returns the file that a chain of symbolic links ends at, so that this file is replaced and not
// a link. The file need not exist yet.
fs::path behind_links(const fs::path& path) {
  fs::path target = path;
  std::error_code error;
  for (int i = 0; !open_file_of(target) && fs::is_symlink(target, error); ++i) {
    if (i == kMostLinks) fail(path, "it is a link that leads back to itself");
    target = folder_of(target) / fs::read_symlink(target, error);
    if (error) fail(path, error.message());
  }
  return target;
}

void write_special(const fs::path& path, Parts parts) {
  const auto number = open_file_of(path);
  const int fd = number ? ::dup(*number) : ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  if (fd < 0) fail(path, reason(errno));
  Descriptor file(fd);
  write_all(file.fd(), parts, path);
  if (const int code = file.close()) fail(path, reason(code));
}

// Gives the unnamed file the name `name`. Returns false if that name is taken.
bool link_as(const Descriptor& file, const fs::path& name, const fs::path& path) {
  const int result =
      ::linkat(AT_FDCWD, handle_of(file).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW);
  if (result == 0) return true;
  if (errno != EEXIST) fail(path, reason(errno));
  return false;
}

void name_temporary(Descriptor& file, const fs::path& path) {
  fs::path name;
  do {
    name = temporary_name(folder_of(path));
  } while (!link_as(file, name, path));
  file.set_temporary(std::move(name));
}

// Gives the new file the owner, group and mode of the older one, as far as the user may give
// files away. The mode is set last, because a change of owner takes bits from it.
void keep_rights(int fd, const struct stat& older) {
  if (::fchown(fd, older.st_uid, older.st_gid) != 0) {
    [[maybe_unused]] const int result = ::fchown(fd, static_cast<uid_t>(-1), older.st_gid);
  }
  ::fchmod(fd, older.st_mode & 07777);
}

void write_beside(const fs::path& path, Parts parts, const std::optional<struct stat>& older) {
  Descriptor file = create_temporary(path);
  if (older) keep_rights(file.fd(), *older);
  write_all(file.fd(), parts, path);
  if (::fsync(file.fd()) != 0) fail(path, reason(errno));
  const bool is_placed = !file.is_named() && !older && link_as(file, path, path);
  if (!is_placed && !file.is_named()) name_temporary(file, path);
  if (const int code = file.close()) {
    if (is_placed) ::unlink(path.c_str());
    fail(path, reason(code));
  }
  if (is_placed) return;
  if (::rename(file.temporary().c_str(), path.c_str()) != 0) fail(path, reason(errno));
  file.keep();
}

/// The file that the name of an output stands for, after all links are followed.
struct Place {
  fs::path path;                      // the end of all links
  std::optional<struct stat> status;  // empty if the file does not exist yet
  bool is_special;                    // the file is written to directly, not replaced
};

void refuse_folder(const fs::path& path, const std::optional<struct stat>& status) {
  if ((status && S_ISDIR(status->st_mode)) || !path.has_filename()) {
    throw Error(
        ErrorKind::usage,
        fmt::format("cannot write '{}': it is a folder, a file name is needed", path.string()));
  }
}

void refuse_read_only(const fs::path& path, const struct stat& status) {
  // Root may write every file. Therefore a file that nobody may write is checked by its mode.
  const bool is_locked = S_ISREG(status.st_mode) && (status.st_mode & 0222) == 0;
  if (is_locked || ::access(path.c_str(), W_OK) != 0) {
    fail(path, is_locked ? "it is read-only; allow writing (chmod u+w) or take another name"
                         : reason(errno));
  }
}

/// Finds the file that `path` stands for. Throws an Error if it cannot be an output.
Place place_of(const fs::path& path) {
  if (path.empty()) throw Error(ErrorKind::usage, "the name of the output file is empty");
  const fs::path target = behind_links(path);
  if (open_file_of(target)) return {target, std::nullopt, true};
  const auto status = status_of(target);
  refuse_folder(path, status);
  if (status) {
    refuse_read_only(target, *status);
  } else if (!status_of(folder_of(target))) {
    const std::string link =
        target == path ? "" : fmt::format("it is a link to '{}', and ", target.string());
    fail(path, fmt::format("{}there is no folder '{}'", link, folder_of(target).string()));
  }
  return {target, status, status && !S_ISREG(status->st_mode)};
}

}  // namespace

void write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
  write_file_of(path, std::span(&bytes, 1));
}

void write_file_of(const fs::path& path, Parts parts) {
  const Place place = place_of(path);
  try {
    if (place.is_special) {
      write_special(place.path, parts);
    } else {
      write_beside(place.path, parts, place.status);
    }
  } catch (const Error& error) {
    if (place.path == path) throw;
    // The message names the link, too, because that is the name that the user gave.
    throw Error(error.kind(), fmt::format("{}; '{}' is a link to it", error.what(), path.string()));
  }
}

void require_writable(const fs::path& path) {
  const Place place = place_of(path);
  // Only creating a file tells. Permissions do not hold for root, nor on read-only and full file
  // systems.
  if (!place.is_special) create_named(place.path);
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  struct stat first {
  }, second{};
  if (::stat(a.c_str(), &first) != 0 || ::stat(b.c_str(), &second) != 0) return false;
  return S_ISREG(first.st_mode) && first.st_dev == second.st_dev && first.st_ino == second.st_ino;
}

bool is_special_file(const fs::path& path) {
  if (open_file_of(path)) return true;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

FileStamp file_stamp(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return {};
  return {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size),
          status.st_mtim.tv_sec * std::int64_t{1000000000} + status.st_mtim.tv_nsec};
}

}  // namespace aerostat
