#include "elevation/tiff_handle.hpp"

#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <new>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.hpp"
#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

/// What libtiff calls the file in its complaints.
constexpr const char* kName = "TIFF";

/// Raises the number of files that this process may have open to the most that the system allows.
void allow_more_files() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
}

int open_for_reading(const char* path) {
  // A pipe would block here without O_NONBLOCK.
  constexpr int kFlags = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
  const int descriptor = ::open(path, kFlags);
  if (descriptor >= 0 || errno != EMFILE) return descriptor;
  allow_more_files();
  return ::open(path, kFlags);
}

}  // namespace

OpenFile::OpenFile(const std::filesystem::path& path, std::filesystem::path shown)
    : shown_(std::move(shown)), descriptor_(open_for_reading(path.c_str())) {
  struct stat status {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0) {
    const int code = errno;
    if (descriptor_ >= 0) ::close(descriptor_);
    throw Error(ErrorKind::io,
                fmt::format("{}: cannot read heights: {}", shown_.string(), std::strerror(code)));
  }
  if (!S_ISREG(status.st_mode)) {
    ::close(descriptor_);
    throw Error(ErrorKind::io,
                fmt::format("{}: cannot read heights: it is not a regular file", shown_.string()));
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

OpenFile::~OpenFile() {
  ::close(descriptor_);
}

std::size_t OpenFile::read(std::uint64_t position, void* bytes, std::size_t count) const {
  std::size_t done = 0;
  while (done < count && position + done < size_) {
    const ssize_t got = ::pread(descriptor_, static_cast<char*>(bytes) + done, count - done,
                                static_cast<off_t>(position + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

/// The functions by which libtiff reaches the file.
struct TiffHandle::Callbacks {
  static TiffHandle& self(thandle_t handle) { return *static_cast<TiffHandle*>(handle); }

  static tmsize_t read(thandle_t handle, void* bytes, tmsize_t count) {
    if (count <= 0) return 0;
    TiffHandle& h = self(handle);
    const std::size_t got = h.file_->read(h.position_, bytes, static_cast<std::size_t>(count));
    h.position_ += got;
    return static_cast<tmsize_t>(got);
  }

  static tmsize_t write(thandle_t, void*, tmsize_t) { return 0; }

  static toff_t seek(thandle_t handle, toff_t offset, int whence) {
    TiffHandle& h = self(handle);
    if (whence == SEEK_SET) h.position_ = offset;
    if (whence == SEEK_CUR) h.position_ += offset;
    if (whence == SEEK_END) h.position_ = h.file_->size() + offset;
    return h.position_;
  }

  static int close(thandle_t) { return 0; }

  static toff_t size(thandle_t handle) { return self(handle).file_->size(); }

  static int keep_complaint(TIFF*, void* handle, const char*, const char* format,
                            va_list arguments) {
    std::array<char, 200> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    try {
      std::string complaint = text.data();
      const std::string start = std::string(kName) + ": ";
      if (complaint.starts_with(start)) complaint.erase(0, start.size());
      self(handle).complaint_ = complaint;
    } catch (const std::bad_alloc&) {
      // The error that is made of the complaint does without it.
    }
    return 1;
  }

  static int ignore(TIFF*, void*, const char*, const char*, va_list) { return 1; }
};

TiffHandle::TiffHandle(std::shared_ptr<const OpenFile> file, std::uint64_t directory)
    : file_(std::move(file)) {
  struct Free {
    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
  };
  const std::unique_ptr<TIFFOpenOptions, Free> options(TIFFOpenOptionsAlloc());
  if (!options) throw std::bad_alloc();
  constexpr std::uint64_t kMostAllocation = kMostBlockBytes + (std::uint64_t{64} << 20);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), static_cast<tmsize_t>(kMostAllocation));
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), Callbacks::keep_complaint, this);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), Callbacks::ignore, this);
  // The places of blocks are read when they are needed (O), and the file is not mapped (m), because
  // a mapped file that becomes shorter ends the process.
  tiff_.reset(TIFFClientOpenExt(kName, "rOm", this, Callbacks::read, Callbacks::write,
                                Callbacks::seek, Callbacks::close, Callbacks::size, nullptr,
                                nullptr, options.get()));
  if (!tiff_ || (directory != 0 && TIFFSetSubDirectory(tiff_.get(), directory) == 0)) {
    refuse(path(), fmt::format("the TIFF file is damaged ({})",
                               complaint_.empty() ? "no directory was found" : complaint_));
  }
}

}  // namespace aerostat::elevation
