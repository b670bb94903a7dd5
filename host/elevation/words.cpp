#include "elevation/words.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace aerostat::elevation {

void Words::read_more() {
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(at_));
  at_ = 0;
  const std::size_t kept = buffer_.size();
  const std::uint64_t left = bytes_.size() - read_;
  buffer_.resize(kept + static_cast<std::size_t>(std::min<std::uint64_t>(left, kPiece)));
  bytes_.read(read_, 0, 1, std::span(buffer_).subspan(kept));
  read_ += buffer_.size() - kept;
}

double plain_number(std::string_view word) {
  // Up to 15 digits and the power of ten are exact in a double, so that their quotient is rounded
  // only once.
  constexpr std::size_t kDigits = 15;
  constexpr std::array kPowers{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                               1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool negative = word.starts_with('-');
  if (negative) word.remove_prefix(1);
  std::uint64_t digits = 0;
  std::size_t count = 0, behind = 0;
  bool has_point = false;
  for (const char c : word) {
    if (c >= '0' && c <= '9') {
      digits = 10 * digits + static_cast<std::uint64_t>(c - '0');
      if (++count > kDigits) return std::numeric_limits<double>::quiet_NaN();
      behind += has_point ? 1 : 0;
    } else if ((c == '.' || c == ',') && !has_point) {
      has_point = true;
    } else {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }
  if (count == 0) return std::numeric_limits<double>::quiet_NaN();
  const double value = static_cast<double>(digits) / kPowers[behind];
  return negative ? -value : value;
}

}  // namespace aerostat::elevation
