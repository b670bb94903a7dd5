#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string_view>

namespace aerostat::asset {

/// Returns the number whose bytes begin at `at` in `bytes`. All of them must lie in `bytes`.
/// `order` is the order in which the file stores the bytes of a number.
template <class Number>
Number number_at(std::string_view bytes, std::size_t at, std::endian order) {
  std::array<char, sizeof(Number)> stored{};
  std::copy_n(bytes.data() + at, sizeof(Number), stored.data());
  if (order != std::endian::native) std::reverse(stored.begin(), stored.end());
  return std::bit_cast<Number>(stored);
}

template <class Number>
Number little_at(std::string_view bytes, std::size_t at) {
  return number_at<Number>(bytes, at, std::endian::little);
}

}  // namespace aerostat::asset
