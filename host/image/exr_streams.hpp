#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include <OpenEXR/ImfIO.h>

#include "core/error.hpp"

/// OpenEXR files in memory.
namespace aerostat::image {

/// The attribute of the mark (image/mark.hpp).
inline constexpr const char* kExrMark = "aerostat";
/// The attributes of a band's development (image/bands.hpp).
inline constexpr const char* kExrExposure = "aerostat.exposureEv";
inline constexpr const char* kExrWhiteBalance = "aerostat.whiteBalance";
inline constexpr const char* kExrVignette = "aerostat.vignette";
inline constexpr const char* kExrGlare = "aerostat.glare";

/// A file in memory that is written. OpenEXR moves back in it to fill in its table of line offsets.
class ExrOutput : public Imf::OStream {
 public:
  ExrOutput() : Imf::OStream("memory") {}

  void write(const char bytes[], int count) override {
    const std::size_t end = position_ + static_cast<std::size_t>(count);
    if (end > bytes_.size()) bytes_.resize(end);
    std::memcpy(bytes_.data() + position_, bytes, static_cast<std::size_t>(count));
    position_ = end;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
  std::size_t position_ = 0;
};

/// A file in memory that is read.
class ExrInput : public Imf::IStream {
 public:
  explicit ExrInput(std::span<const std::uint8_t> bytes) : Imf::IStream("memory"), bytes_(bytes) {}

  bool read(char to[], int count) override {
    const auto wanted = static_cast<std::size_t>(count);
    if (wanted > bytes_.size() - std::min<std::size_t>(position_, bytes_.size())) {
      throw Error(ErrorKind::bad_data, "the file ends too early");
    }
    std::memcpy(to, bytes_.data() + position_, wanted);
    position_ += wanted;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::uint64_t position_ = 0;
};

}  // namespace aerostat::image
