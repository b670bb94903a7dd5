#include "image/deflate.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include <tbb/parallel_for.h>

namespace aerostat::image {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kPart = std::size_t{1} << 17;
constexpr std::size_t kWindow = 32768;
constexpr std::size_t kShortest = 4, kLongest = 258;
constexpr int kHashBits = 14;

struct Code {
  std::uint32_t bits = 0;
  int count = 0;
};

constexpr std::uint32_t reversed(std::uint32_t code, int count) {
  std::uint32_t result = 0;
  for (int i = 0; i < count; ++i) result |= (code >> i & 1u) << (count - 1 - i);
  return result;
}

// The fixed code of RFC 1951, section 3.2.6, for literals and lengths.
constexpr Code fixed_code(std::uint32_t symbol) {
  if (symbol < 144) return {reversed(0x30 + symbol, 8), 8};
  if (symbol < 256) return {reversed(0x190 + symbol - 144, 9), 9};
  if (symbol < 280) return {reversed(symbol - 256, 7), 7};
  return {reversed(0xc0 + symbol - 280, 8), 8};
}

constexpr std::uint32_t kEndOfBlock = 256;

// Codes of lengths with their extra bits appended, section 3.2.5: steps double every four symbols.
constexpr Code length_code(std::uint32_t length) {
  if (length == kLongest) return fixed_code(285);
  const std::uint32_t n = length - 3;
  const int extra = n < 8 ? 0 : std::bit_width(n) - 3;
  const std::uint32_t symbol = 257 + 4 * static_cast<std::uint32_t>(extra) + (n >> extra);
  const Code code = fixed_code(symbol);
  return {code.bits | (n & ((1u << extra) - 1)) << code.count, code.count + extra};
}

constexpr Code distance_code(std::uint32_t distance) {
  const std::uint32_t n = distance - 1;
  const int extra = n < 4 ? 0 : std::bit_width(n) - 2;
  const std::uint32_t symbol = 2 * static_cast<std::uint32_t>(extra) + (n >> extra);
  return {reversed(symbol, 5) | (n & ((1u << extra) - 1)) << 5, 5 + extra};
}

constexpr auto kLiterals = [] {
  std::array<Code, 257> codes{};
  for (std::uint32_t s = 0; s < codes.size(); ++s) codes[s] = fixed_code(s);
  return codes;
}();

constexpr auto kLengths = [] {
  std::array<Code, kLongest + 1> codes{};
  for (std::uint32_t n = 3; n <= kLongest; ++n) codes[n] = length_code(n);
  return codes;
}();

class BitWriter {
 public:
  explicit BitWriter(Bytes& out) : out_(out) {}

  // At most 32 bits at a time.
  void put(Code code) {
    pending_ |= std::uint64_t{code.bits} << count_;
    count_ += code.count;
    while (count_ >= 8) {
      out_.push_back(static_cast<std::uint8_t>(pending_));
      pending_ >>= 8;
      count_ -= 8;
    }
  }

  void align() {
    if (count_ > 0) put({0, 8 - count_});
  }

 private:
  Bytes& out_;
  std::uint64_t pending_ = 0;
  int count_ = 0;
};

std::uint32_t four_bytes(const std::uint8_t* at) {
  std::uint32_t value = 0;
  std::memcpy(&value, at, sizeof(value));
  return value;
}

std::uint32_t hash(std::uint32_t four) {
  return four * 2654435761u >> (32 - kHashBits);
}

std::size_t match_length(const std::uint8_t* a, const std::uint8_t* b, std::size_t most) {
  std::size_t n = 0;
  while (n < most && a[n] == b[n]) ++n;
  return n;
}

// A block of its own, not the last, that ends at a byte.
Bytes compress_part(std::span<const std::uint8_t> data) {
  Bytes out;
  out.reserve(data.size());
  BitWriter bits(out);
  bits.put({0b010, 3});
  std::vector<std::uint32_t> seen(std::size_t{1} << kHashBits, 0);  // position after, 0: none
  const std::uint8_t* const at = data.data();
  std::size_t i = 0;
  while (i + kShortest <= data.size()) {
    const std::uint32_t four = four_bytes(at + i);
    std::uint32_t& last = seen[hash(four)];
    const std::size_t distance = i + 1 - last;
    const bool found = last != 0 && distance <= kWindow && four_bytes(at + last - 1) == four;
    last = static_cast<std::uint32_t>(i + 1);
    if (found) {
      const std::size_t length =
          match_length(at + i, at + i - distance, std::min(kLongest, data.size() - i));
      bits.put(kLengths[length]);
      bits.put(distance_code(static_cast<std::uint32_t>(distance)));
      i += length;
    } else {
      bits.put(kLiterals[at[i++]]);
    }
  }
  while (i < data.size()) bits.put(kLiterals[at[i++]]);
  bits.put(kLiterals[kEndOfBlock]);
  // An empty stored block begins the next part at a byte.
  bits.put({0, 3});
  bits.align();
  out.insert(out.end(), {0x00, 0x00, 0xff, 0xff});
  return out;
}

std::uint32_t adler32(std::span<const std::uint8_t> data) {
  constexpr std::size_t kNoOverflow = 5552;
  std::uint32_t a = 1, b = 0;
  while (!data.empty()) {
    const auto some = data.first(std::min(kNoOverflow, data.size()));
    for (const std::uint8_t byte : some) {
      a += byte;
      b += a;
    }
    a %= 65521;
    b %= 65521;
    data = data.subspan(some.size());
  }
  return b << 16 | a;
}

}  // namespace

std::vector<std::uint8_t> deflate(std::span<const std::uint8_t> data) {
  std::vector<Bytes> parts((data.size() + kPart - 1) / kPart);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t k) {
    const std::size_t begin = k * kPart;
    parts[k] = compress_part(data.subspan(begin, std::min(kPart, data.size() - begin)));
  });
  Bytes out{0x78, 0x01};
  for (const Bytes& part : parts) out.insert(out.end(), part.begin(), part.end());
  // The last block: nothing, by the fixed code.
  out.insert(out.end(), {0x03, 0x00});
  const std::uint32_t sum = adler32(data);
  for (int shift = 24; shift >= 0; shift -= 8)
    out.push_back(static_cast<std::uint8_t>(sum >> shift));
  return out;
}

}  // namespace aerostat::image
