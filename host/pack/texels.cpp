#include "pack/texels.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace aerostat::pack {

std::uint32_t Texels::add(std::shared_ptr<const void> owner, std::span<const std::uint32_t> words) {
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (words.size() > kMost - size_) {
    throw Error(ErrorKind::exhausted,
                fmt::format("the pictures of the scene have {} texels together, expected at most "
                            "{}; smaller pictures need fewer",
                            size_ + words.size(), kMost));
  }
  const auto first = static_cast<std::uint32_t>(size_);
  if (!words.empty()) parts_.push_back({std::move(owner), words});
  size_ += words.size();
  return first;
}

bool Texels::operator==(const Texels& other) const {
  return std::equal(parts_.begin(), parts_.end(), other.parts_.begin(), other.parts_.end(),
                    [](const Part& a, const Part& b) {
                      return a.words.data() == b.words.data() && a.words.size() == b.words.size();
                    });
}

}  // namespace aerostat::pack
