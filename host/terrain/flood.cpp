#include "flood.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace aerostat::terrain {
namespace {

constexpr int kLast = std::numeric_limits<int>::max();

/// Returns a key whose upper half orders like the height and whose lower half is the place of the
/// node.
std::uint64_t key_of(float height, int place) {
  const auto bits = std::bit_cast<std::uint32_t>(height + 0.0f);
  const std::uint32_t ordered = (bits >> 31) != 0 ? ~bits : bits | 0x80000000u;
  return std::uint64_t{ordered} << 32 | static_cast<std::uint32_t>(place);
}

/// Sorts keys by their upper halves. Keys with equal upper halves keep their order.
void radix_sort(std::vector<std::uint64_t>& keys) {
  constexpr int kDigit = 11, kValues = 1 << kDigit;
  std::vector<std::uint64_t> sorted(keys.size());
  for (int shift = 32; shift < 64; shift += kDigit) {
    std::vector<std::uint32_t> place(kValues, 0);
    for (const std::uint64_t key : keys) ++place[(key >> shift) & (kValues - 1)];
    std::uint32_t sum = 0;
    for (std::uint32_t& one : place) sum += std::exchange(one, sum);
    for (const std::uint64_t key : keys) sorted[place[(key >> shift) & (kValues - 1)]++] = key;
    keys.swap(sorted);
  }
}

/// A set of numbers from which the least is taken. This is fast if the least number rises in the
/// long run.
class RisingSet {
 public:
  explicit RisingSet(std::size_t count) : words_((count + 63) / 64 + 1, 0) {}

  void put(std::uint32_t number) {
    words_[number / 64] |= std::uint64_t{1} << (number % 64);
    word_ = std::min<std::size_t>(word_, number / 64);
  }

  /// Returns the least number, which stays in the set, or kLast if the set is empty.
  int least() {
    while (word_ < words_.size() && words_[word_] == 0) ++word_;
    if (word_ == words_.size()) return kLast;
    return static_cast<int>(64 * word_) + std::countr_zero(words_[word_]);
  }
  void drop_least() { words_[word_] &= words_[word_] - 1; }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t word_ = 0;
};

class Flood {
 public:
  Flood(const RimmedGrid& grid, const Rimmed<float>& heights) : grid_(grid), heights_(heights) {
    sorted_.reserve(heights.size());
    for (int j = 0; j < grid.nodes; ++j)
      for (int i = 0; i < grid.nodes; ++i)
        sorted_.push_back(key_of(heights[grid.at(i, j)], grid.at(i, j)));
    radix_sort(sorted_);
    by_height_.resize(heights.size());
    for (std::size_t k = 0; k < sorted_.size(); ++k)
      by_height_[place(static_cast<int>(k))] = static_cast<std::uint32_t>(k);
  }

  Rimmed<int> run(const Rimmed<std::uint8_t>& outlets) {
    RisingSet waiting(sorted_.size());
    // The nodes of basins that the water runs into at its present level.
    std::priority_queue<int, std::vector<int>, std::greater<>> running;
    Rimmed<int> ranks(heights_.size(), kLast);
    Rimmed<std::uint8_t> seen(heights_.size(), 1);
    for (const std::uint64_t key : sorted_) {
      const int node = static_cast<int>(static_cast<std::uint32_t>(key));
      seen[node] = outlets[node];
      if (outlets[node] != 0) waiting.put(by_height_[node]);
    }
    std::array<int, 8> steps;
    for (int d = 0; d < 8; ++d) steps[d] = grid_.step(d);
    float level = 0.0f;
    for (int reached = 0;; ++reached) {
      const int next = waiting.least();
      if (next == kLast && running.empty()) break;
      int node = next == kLast ? kLast : place(next);
      if (!running.empty() && (next == kLast || level < heights_[node] || running.top() < node)) {
        node = running.top();
        running.pop();
      } else {
        level = heights_[node];
        waiting.drop_least();
      }
      ranks[node] = reached;
      for (const int step : steps) {
        const int other = node + step;
        if (seen[other] != 0) continue;
        seen[other] = 1;
        if (heights_[other] > level) {
          waiting.put(by_height_[other]);
        } else {
          running.push(other);
        }
      }
    }
    return ranks;
  }

 private:
  int place(int k) const { return static_cast<int>(static_cast<std::uint32_t>(sorted_[k])); }

  const RimmedGrid& grid_;
  const Rimmed<float>& heights_;
  std::vector<std::uint64_t> sorted_;
  Rimmed<std::uint32_t> by_height_;  // place of each node in `sorted_`
};

}  // namespace

Rimmed<int> flood_ranks(const RimmedGrid& grid, const Rimmed<float>& heights,
                        const Rimmed<std::uint8_t>& outlets) {
  return Flood(grid, heights).run(outlets);
}

}  // namespace aerostat::terrain
