#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "elevation/bytes.hpp"

namespace aerostat::elevation {

/// The words of a text, which white space and control characters part. The text is read piece by
/// piece.
class Words {
 public:
  /// The longest word. A longer one is returned in parts.
  static constexpr std::size_t kLongest = 4096;

  /// Reads from the byte `first` on.
  explicit Words(const ByteSource& bytes, std::uint64_t first = 0) : bytes_(bytes), read_(first) {}

  /// Returns the next word, which is valid until the next call. It is empty at the end of the text.
  std::string_view next() {
    while (true) {
      while (at_ < buffer_.size() && is_space(buffer_[at_])) ++at_;
      std::size_t end = at_;
      while (end < buffer_.size() && !is_space(buffer_[end])) ++end;
      const bool is_whole = end < buffer_.size() || read_ == bytes_.size();
      if (is_whole || end - at_ >= kLongest) {
        const std::string_view word(reinterpret_cast<const char*>(buffer_.data()) + at_, end - at_);
        at_ = end;
        return word;
      }
      read_more();
    }
  }

  /// Gives back a word, so that it is the next one again.
  void put_back(std::string_view word) { at_ -= word.size(); }

  /// Returns the place in bytes behind the last word.
  std::uint64_t place() const { return read_ - (buffer_.size() - at_); }

 private:
  static bool is_space(std::uint8_t c) { return c <= ' '; }
  void read_more();

  const ByteSource& bytes_;
  std::uint64_t read_;  // the place behind the bytes that were read
  std::vector<std::uint8_t> buffer_;
  std::size_t at_ = 0;
};

/// Returns the value of a word of digits with at most one decimal point or comma, or NaN for any
/// other word. It is several times as fast as general conversion, and as exact.
double plain_number(std::string_view word);

}  // namespace aerostat::elevation
