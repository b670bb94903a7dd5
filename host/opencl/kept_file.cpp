#include "opencl/kept_file.hpp"

#include <cstdint>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.hpp"
#include "core/file.hpp"

namespace aerostat::opencl {
namespace {

namespace fs = std::filesystem;

struct File {
  int descriptor = -1;
  ~File() {
    if (descriptor >= 0) close(descriptor);
  }
};

}  // namespace

std::optional<std::string> read_kept_file(const fs::path& path) {
  // O_NONBLOCK is needed because opening a pipe in the place of the file would wait for a writer.
  const File file{open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW)};
  struct stat status = {};
  if (file.descriptor < 0 || fstat(file.descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    return std::nullopt;
  }
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const auto count = read(file.descriptor, bytes.data() + done, bytes.size() - done);
    if (count <= 0) return std::nullopt;
    done += static_cast<std::size_t>(count);
  }
  return bytes;
}

bool write_kept_file(const fs::path& path, std::string_view bytes) {
  try {
    write_file(path, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  } catch (const Error&) {
    return false;
  }
  return true;
}

bool remove_kept(const fs::path& path) {
  std::error_code error;
  const fs::path aside =
      path.parent_path() / fmt::format("removed-{}-{}", getpid(), path.filename().string());
  fs::rename(path, aside, error);
  std::error_code ignored;
  fs::remove_all(error ? path : aside, ignored);
  return fs::symlink_status(path, ignored).type() == fs::file_type::not_found;
}

}  // namespace aerostat::opencl
