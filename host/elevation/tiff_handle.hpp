#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include <tiffio.h>

namespace aerostat::elevation {

/// The most bytes and samples of a strip or tile once it is decoded. All of it has to be in memory
/// at once.
inline constexpr std::uint64_t kMostBlockBytes = std::uint64_t{1} << 29;
inline constexpr std::uint64_t kMostBlockSamples = std::uint64_t{1} << 27;

/// A file that stays open, so that another file which takes its name meanwhile does no harm.
class OpenFile {
 public:
  /// Messages call the file `shown`. Throws Error{io} if `path` is no regular file that can be
  /// read.
  OpenFile(const std::filesystem::path& path, std::filesystem::path shown);
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  const std::filesystem::path& shown() const { return shown_; }
  std::uint64_t size() const { return size_; }

  /// Reads up to `count` bytes at a position and returns how many there were. It may be used from
  /// any thread.
  std::size_t read(std::uint64_t position, void* bytes, std::size_t count) const;

 private:
  std::filesystem::path shown_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

/// A directory of a TIFF file, as libtiff gives it. One thread uses it at a time. It prints
/// nothing, and no allocation of libtiff exceeds what a block may take.
class TiffHandle {
 public:
  /// Opens the first directory, or the one at a position. Throws Error{bad_data} if there is none.
  explicit TiffHandle(std::shared_ptr<const OpenFile> file, std::uint64_t directory = 0);
  TiffHandle(const TiffHandle&) = delete;
  TiffHandle& operator=(const TiffHandle&) = delete;

  TIFF* get() const { return tiff_.get(); }
  const std::filesystem::path& path() const { return file_->shown(); }
  /// Returns what libtiff said of the last failure, shortened.
  const std::string& complaint() const { return complaint_; }

 private:
  struct Callbacks;
  struct Close {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
  };

  std::shared_ptr<const OpenFile> file_;
  std::uint64_t position_ = 0;
  std::string complaint_;
  std::unique_ptr<TIFF, Close> tiff_;
};

}  // namespace aerostat::elevation
