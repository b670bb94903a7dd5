#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace aerostat::pack {

/// The buffer of texels that kernels read: words of pictures, one picture behind the other. It
/// copies no words, and keeps whoever has them.
class Texels {
 public:
  struct Part {
    std::shared_ptr<const void> owner;
    std::span<const std::uint32_t> words;
  };

  /// Appends the words of a picture, which `owner` keeps unchanged, and returns the place of the
  /// first one. Throws Error{exhausted} if a place would not fit into 32 bits.
  std::uint32_t add(std::shared_ptr<const void> owner, std::span<const std::uint32_t> words);

  /// The parts that have words, in the order of the buffer.
  const std::vector<Part>& parts() const { return parts_; }
  /// The number of words of all parts.
  std::size_t size() const { return size_; }

  /// Whether the parts are the same words in memory, at the same places of the buffer.
  bool operator==(const Texels& other) const;

 private:
  std::vector<Part> parts_;
  std::size_t size_ = 0;
};

}  // namespace aerostat::pack
