#include "elevation/bytes.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.hpp"
#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw Error(ErrorKind::io, fmt::format("{}: cannot read heights: {}", path.string(), reason));
}

/// An open regular file.
class File {
 public:
  explicit File(const std::filesystem::path& path)
      : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    if (descriptor_ < 0) fail(path, std::strerror(errno));
  }
  ~File() { ::close(descriptor_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  std::uint64_t size() const {
    struct stat status = {};
    if (::fstat(descriptor_, &status) != 0) fail(path_, std::strerror(errno));
    if (!S_ISREG(status.st_mode)) fail(path_, "it is not a regular file");
    return static_cast<std::uint64_t>(status.st_size);
  }

  void read(std::uint64_t offset, std::span<std::uint8_t> bytes) const {
    while (!bytes.empty()) {
      const ssize_t done =
          ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
      if (done < 0 && errno == EINTR) continue;
      if (done < 0) fail(path_, std::strerror(errno));
      if (done == 0) fail(path_, "it became shorter while it was in use");
      offset += static_cast<std::uint64_t>(done);
      bytes = bytes.subspan(static_cast<std::size_t>(done));
    }
  }

 private:
  std::filesystem::path path_;
  int descriptor_;
};

class FileBytes final : public ByteSource {
 public:
  explicit FileBytes(std::filesystem::path path)
      : path_(std::move(path)), size_(File(path_).size()) {}

  std::uint64_t size() const override { return size_; }

  void read(std::uint64_t offset, std::uint64_t stride, std::size_t count,
            std::span<std::uint8_t> bytes) const override {
    const File file(path_);
    const std::size_t length = count == 0 ? 0 : bytes.size() / count;
    for (std::size_t i = 0; i < count; ++i) {
      file.read(offset + i * stride, bytes.subspan(i * length, length));
    }
  }

 private:
  std::filesystem::path path_;
  std::uint64_t size_;
};

class MemoryBytes final : public ByteSource {
 public:
  explicit MemoryBytes(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}

  std::uint64_t size() const override { return bytes_.size(); }

  void read(std::uint64_t offset, std::uint64_t stride, std::size_t count,
            std::span<std::uint8_t> bytes) const override {
    const std::size_t length = count == 0 ? 0 : bytes.size() / count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::span<const std::uint8_t> piece =
          std::span(bytes_).subspan(static_cast<std::size_t>(offset + i * stride), length);
      std::copy(piece.begin(), piece.end(),
                bytes.begin() + static_cast<std::ptrdiff_t>(i * length));
    }
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::shared_ptr<const ByteSource> file_bytes(const std::filesystem::path& path) {
  return std::make_shared<FileBytes>(path);
}

std::shared_ptr<const ByteSource> memory_bytes(std::vector<std::uint8_t> bytes) {
  return std::make_shared<MemoryBytes>(std::move(bytes));
}

std::vector<std::uint8_t> read_whole(const std::filesystem::path& path, std::uint64_t most) {
  const File file(path);
  const std::uint64_t size = file.size();
  if (size > most) {
    refuse(path, fmt::format("the file has {} bytes, and at most {} are read", size, most));
  }
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
  file.read(0, bytes);
  return bytes;
}

}  // namespace aerostat::elevation
