#include "receivers.hpp"

#include <algorithm>
#include <limits>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/simd.hpp"
#include "noise.hpp"

namespace aerostat::terrain {
namespace {

constexpr int kBlock = 128;

/// Some neighbouring nodes of a row.
struct Run {
  const float* heights;  // height of the first node; others follow
  const int* ranks;      // null where heights tell which node comes before
  int first;             // number of the first node in the grid
  int count;
  std::array<int, 8> steps;
  std::array<float, 8> lengths;
  std::uint32_t seed;
};

/// The best neighbour found so far.
struct Choice {
  float preference;
  std::int32_t direction;
};

template <bool by_rank, int d>
AEROSTAT_INLINE void consider(const Run& run, int i, Choice& best) {
  const float here = run.heights[i], there = run.heights[i + run.steps[d]];
  constexpr bool lies_before =
      kNeighbors[d][1] < 0 || (kNeighbors[d][1] == 0 && kNeighbors[d][0] < 0);
  bool counts;
  if constexpr (by_rank) {
    counts = run.ranks[i + run.steps[d]] < run.ranks[i];
  } else {
    counts = lies_before ? there <= here : there < here;
  }
  const std::uint32_t hash = lattice_hash(run.seed, run.first + i, d);
  const float reluctance =
      0.7f + 0.6f * static_cast<float>(static_cast<std::int32_t>(hash >> 8)) / 16777216.0f;
  const float drop = (here - there) / run.lengths[d];
  const float preference = drop >= 0.0f ? drop * reluctance : drop;
  const bool better = counts & (preference > best.preference);
  best.preference = better ? preference : best.preference;
  best.direction = better ? d : best.direction;
}

template <bool by_rank>
AEROSTAT_INLINE void choose_loop(const Run& given, std::uint8_t* directions) {
  const Run run = given;
  std::array<std::int32_t, kBlock> chosen;
  const int count = run.count;
  for (int i = 0; i < count; ++i) {
    Choice best{-std::numeric_limits<float>::infinity(), kNoReceiver};
    consider<by_rank, 0>(run, i, best);
    consider<by_rank, 1>(run, i, best);
    consider<by_rank, 2>(run, i, best);
    consider<by_rank, 3>(run, i, best);
    consider<by_rank, 4>(run, i, best);
    consider<by_rank, 5>(run, i, best);
    consider<by_rank, 6>(run, i, best);
    consider<by_rank, 7>(run, i, best);
    chosen[i] = best.direction;
  }
  for (int i = 0; i < count; ++i) directions[i] = static_cast<std::uint8_t>(chosen[i]);
}

AEROSTAT_INLINE void either_loop(const Run& run, std::uint8_t* directions) {
  if (run.ranks != nullptr) {
    choose_loop<true>(run, directions);
  } else {
    choose_loop<false>(run, directions);
  }
}

Rimmed<std::uint8_t> choose(const RimmedGrid& grid, const Rimmed<float>& heights, const int* ranks,
                            const Rimmed<std::uint8_t>& outlets, std::uint32_t seed) {
  Rimmed<std::uint8_t> directions(grid.size(), kNoReceiver);
  Run all{};
  for (int d = 0; d < 8; ++d) {
    all.steps[d] = grid.step(d);
    all.lengths[d] = grid.length(d);
  }
  all.seed = seed;
  tbb::parallel_for(tbb::blocked_range<int>(0, grid.nodes, 16), [&](const auto& rows) {
    for (int j = rows.begin(); j != rows.end(); ++j) {
      Run run = all;
      for (int i = 0; i < grid.nodes; i += kBlock) {
        const int place = grid.at(i, j);
        run.heights = &heights[place];
        run.ranks = ranks == nullptr ? nullptr : ranks + place;
        run.first = j * grid.nodes + i;
        run.count = std::min(kBlock, grid.nodes - i);
        std::uint8_t* const to = &directions[place];
        in_vectors([&]() AEROSTAT_INLINE_LAMBDA { either_loop(run, to); });
      }
      const int begin = grid.at(0, j);
      for (int place = begin; place < begin + grid.nodes; ++place)
        if (outlets[place] != 0) directions[place] = kNoReceiver;
    }
  });
  return directions;
}

}  // namespace

Rimmed<std::uint8_t> receivers_by_height(const RimmedGrid& grid, const Rimmed<float>& heights,
                                         const Rimmed<std::uint8_t>& outlets, std::uint32_t seed) {
  return choose(grid, heights, nullptr, outlets, seed);
}

Rimmed<std::uint8_t> receivers_by_rank(const RimmedGrid& grid, const Rimmed<float>& heights,
                                       const Rimmed<int>& ranks,
                                       const Rimmed<std::uint8_t>& outlets, std::uint32_t seed) {
  return choose(grid, heights, ranks.data(), outlets, seed);
}

}  // namespace aerostat::terrain
