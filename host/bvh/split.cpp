#include "split.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <tbb/parallel_for.h>

#include "loops.hpp"

namespace aerostat::bvh {
namespace {

// Ranges of at least this size are split on all cores. Their chunks depend only on the size of
// the range, because the result must not depend on the number of threads.
constexpr std::size_t kParallelCount = std::size_t{1} << 17;
constexpr std::size_t kMinChunk = std::size_t{1} << 14;
constexpr std::size_t kMaxChunks = 64;

// Returns the number of bins for a range. In small ranges, more bins find no better planes.
int bins_for(std::size_t count) {
  return count > 256 ? kMostBins : kMostBins / 2;
}

void fill(Bins& bins, std::span<const Primitive> range, const BinMap& map) {
  loops().fill(bins, range.data(), range.size(), map);
}

Parts partition(std::span<Primitive> range, const BinMap& map, const Plane& plane,
                const Box (&bounds)[2]) {
  Parts parts;
  parts.left_count = static_cast<std::uint32_t>(
      loops().partition(range.data(), range.size(), map, plane, parts.centroids));
  for (int side = 0; side < 2; ++side) parts.bounds[side] = bounds[side];
  return parts;
}

void merge(Bins& bins, const Bins& other) {
  for (int i = 0; i < bins.count; ++i) {
    for (int axis = 0; axis < 3; ++axis)
      bins.bin[i].box[axis] = united<false>(bins.bin[i].box[axis], other.bin[i].box[axis]);
    bins.bin[i].held += other.bin[i].held;
  }
}

struct Chunks {
  explicit Chunks(std::size_t total_count)
      : total(total_count),
        size(std::max(kMinChunk, (total_count + kMaxChunks - 1) / kMaxChunks)),
        count((total_count + size - 1) / size) {}
  std::size_t begin(std::size_t i) const { return i * size; }
  std::size_t end(std::size_t i) const { return std::min(total, (i + 1) * size); }

  std::size_t total, size, count;
};

Bins fill_parallel(std::span<const Primitive> range, const BinMap& map, const Chunks& chunks) {
  std::vector<Bins> partial(chunks.count, Bins(map.bins));
  tbb::parallel_for(std::size_t{0}, chunks.count, [&](std::size_t i) {
    fill(partial[i], range.subspan(chunks.begin(i), chunks.end(i) - chunks.begin(i)), map);
  });
  for (std::size_t i = 1; i < partial.size(); ++i) merge(partial[0], partial[i]);
  return partial[0];
}

struct Interval {
  std::size_t begin, end;
};

// Swaps the n-th element of list `a` with the n-th of list `b`. Both lists have the same number
// of elements in all.
void swap_lists(std::span<Primitive> range, std::vector<Interval> a, std::vector<Interval> b) {
  struct Swap {
    std::size_t from, to, count;
  };
  std::vector<Swap> swaps;
  for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
    const std::size_t n = std::min(a[i].end - a[i].begin, b[k].end - b[k].begin);
    if (n > 0) swaps.push_back({a[i].begin, b[k].begin, n});
    a[i].begin += n;
    b[k].begin += n;
    if (a[i].begin == a[i].end) ++i;
    if (k < b.size() && b[k].begin == b[k].end) ++k;
  }
  tbb::parallel_for(std::size_t{0}, swaps.size(), [&](std::size_t s) {
    Primitive* const from = range.data() + swaps[s].from;
    std::swap_ranges(from, from + swaps[s].count, range.data() + swaps[s].to);
  });
}

// Partitions each chunk and then swaps the primitives that lie on the wrong side of the common
// middle.
Parts partition_parallel(std::span<Primitive> range, const BinMap& map, const Plane& plane,
                         const Box (&bounds)[2], const Chunks& chunks) {
  std::vector<Parts> partial(chunks.count);
  tbb::parallel_for(std::size_t{0}, chunks.count, [&](std::size_t i) {
    const std::size_t begin = chunks.begin(i);
    partial[i] = partition(range.subspan(begin, chunks.end(i) - begin), map, plane, bounds);
  });
  Parts parts = partial[0];
  for (std::size_t i = 1; i < partial.size(); ++i) {
    parts.left_count += partial[i].left_count;
    for (int side = 0; side < 2; ++side) parts.centroids[side].grow(partial[i].centroids[side]);
  }
  const std::size_t middle = parts.left_count;
  std::vector<Interval> early_right, late_left;
  for (std::size_t i = 0; i < chunks.count; ++i) {
    const std::size_t begin = chunks.begin(i), split = begin + partial[i].left_count;
    if (split < std::min(chunks.end(i), middle))
      early_right.push_back({split, std::min(chunks.end(i), middle)});
    if (std::max(begin, middle) < split) late_left.push_back({std::max(begin, middle), split});
  }
  swap_lists(range, std::move(early_right), std::move(late_left));
  return parts;
}

}  // namespace

std::optional<Parts> split_binned(std::span<Primitive> range, const Box& centroids) {
  const BinMap map(centroids, bins_for(range.size()));
  Box bounds[2];
  if (range.size() >= kParallelCount) {
    const Chunks chunks(range.size());
    const Plane plane = loops().search(fill_parallel(range, map, chunks), bounds);
    if (plane.axis < 0) return std::nullopt;
    return partition_parallel(range, map, plane, bounds, chunks);
  }
  Bins bins(map.bins);
  fill(bins, range, map);
  const Plane plane = loops().search(bins, bounds);
  if (plane.axis < 0) return std::nullopt;
  return partition(range, map, plane, bounds);
}

Parts split_halves(std::span<Primitive> range, const Box& centroids) {
  const int axis = centroids.widest_axis();
  const std::size_t half = range.size() / 2;
  if (centroids.hi[axis] > centroids.lo[axis]) {
    std::nth_element(range.begin(), range.begin() + static_cast<std::ptrdiff_t>(half), range.end(),
                     [axis](const Primitive& a, const Primitive& b) {
                       const float ca = a.lo[axis] * 0.25f + a.hi[axis] * 0.25f;
                       const float cb = b.lo[axis] * 0.25f + b.hi[axis] * 0.25f;
                       return ca != cb ? ca < cb : a.triangle < b.triangle;
                     });
  }
  Parts parts;
  parts.left_count = static_cast<std::uint32_t>(half);
  for (std::size_t i = 0; i < range.size(); ++i) {
    const Box box = load_box(range[i]);
    const int side = i < half ? 0 : 1;
    parts.bounds[side].grow(box);
    parts.centroids[side].grow(box.half_centre());
  }
  return parts;
}

}  // namespace aerostat::bvh
