#include <atomic>
#include <cerrno>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.hpp"
#include "image/write.hpp"

namespace aerostat::image {

namespace {

namespace fs = std::filesystem;

std::string reason(int code) {
  return std::generic_category().message(code);
}

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
  throw Error(ErrorKind::io, fmt::format("cannot write '{}': {}", path.string(), why));
}

/// An open file; what it names is removed unless it is kept.
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

  /// The system's error code, 0 if the data arrived.
  int close() { return ::close(std::exchange(fd_, -1)) == 0 ? 0 : errno; }

 private:
  int fd_;
  fs::path temporary_;
};

fs::path folder_of(const fs::path& path) {
  const fs::path parent = path.parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

fs::path temporary_name(const fs::path& folder) {
  static std::atomic<unsigned> counter{0};
  return folder / fmt::format(".aerostat-{}-{}.tmp", ::getpid(), counter++);
}

constexpr mode_t kMode = 0666;  // less the umask

Descriptor create_named(const fs::path& path) {
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

// A file without a name vanishes with the process, even if it is killed. Not every file system has
// them, and to be named later they need /proc.
Descriptor create_temporary(const fs::path& path) {
  const int fd = ::open(folder_of(path).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, kMode);
  if (fd < 0) return create_named(path);
  Descriptor file(fd);
  if (::access(handle_of(file).c_str(), F_OK) != 0) return create_named(path);
  return file;
}

void write_all(int fd, std::span<const std::uint8_t> bytes, const fs::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(path, reason(written < 0 ? errno : ENOSPC));
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

std::optional<struct stat> status_of(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) return status;
  if (errno != ENOENT) fail(path, reason(errno));
  return std::nullopt;
}

void write_special(const fs::path& path, std::span<const std::uint8_t> bytes) {
  // /dev/stdout is asked for by its number: opening it anew would truncate a file it stands for.
  const int fd = path == "/dev/stdout" ? ::dup(STDOUT_FILENO)
                                       : ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  if (fd < 0) fail(path, reason(errno));
  Descriptor file(fd);
  write_all(file.fd(), bytes, path);
  if (const int code = file.close()) fail(path, reason(code));
}

// Gives the unnamed file `name`; false if that name is taken.
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

void write_beside(const fs::path& path, std::span<const std::uint8_t> bytes,
                  const std::optional<struct stat>& older) {
  Descriptor file = create_temporary(path);
  if (older) ::fchmod(file.fd(), older->st_mode & 07777);
  write_all(file.fd(), bytes, path);
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

bool is_special(const fs::path& path, const std::optional<struct stat>& status) {
  return path == "/dev/stdout" || (status && !S_ISREG(status->st_mode));
}

// Through a link the file it points to is replaced, not the link.
fs::path behind_links(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  fs::path target = fs::canonical(path, error);
  return error ? path : target;
}

void refuse_folder(const fs::path& path, const std::optional<struct stat>& status) {
  if (path.empty()) throw Error(ErrorKind::usage, "the name of the output file is empty");
  if ((status && S_ISDIR(status->st_mode)) || !path.has_filename()) {
    throw Error(
        ErrorKind::usage,
        fmt::format("cannot write '{}': it is a folder, a file name is needed", path.string()));
  }
}

}  // namespace

void write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
  const auto status = status_of(path);
  refuse_folder(path, status);
  if (is_special(path, status)) {
    write_special(path, bytes);
  } else {
    write_beside(behind_links(path), bytes, status);
  }
}

void require_writable(const fs::path& path) {
  const auto status = status_of(path);
  refuse_folder(path, status);
  if (path == "/dev/stdout") return;
  if (status && ::access(path.c_str(), W_OK) != 0) fail(path, reason(errno));
  if (is_special(path, status)) return;
  const fs::path target = behind_links(path);
  const auto folder = status_of(folder_of(target));
  if (!folder) fail(path, fmt::format("there is no folder '{}'", folder_of(target).string()));
  // Only a try tells: permissions lie to root, on read-only and on full file systems.
  create_named(target);
}

}  // namespace aerostat::image
