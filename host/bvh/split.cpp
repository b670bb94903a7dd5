#include "split.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <tbb/parallel_for.h>

namespace aerostat::bvh {
namespace {

constexpr int kBins = 32;
// From here on a range is worth all cores. Its chunks depend on its size alone: the result must not
// depend on the number of threads.
constexpr std::size_t kParallelCount = std::size_t{1} << 17;
constexpr std::size_t kMinChunk = std::size_t{1} << 14;
constexpr std::size_t kMaxChunks = 64;

struct Bins {
  Box box[3][kBins];
  std::uint32_t count[3][kBins] = {};

  void merge(const Bins& other) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < kBins; ++i) {
        box[axis][i].grow(other.box[axis][i]);
        count[axis][i] += other.count[axis][i];
      }
    }
  }
};

// Maps centroids to bins. An axis whose extent floats cannot divide has scale 0: all in one bin.
struct BinMap {
  Float4 origin;
  Float4 scale = broadcast(0.0f);

  explicit BinMap(const Box& centroids) : origin(centroids.lo) {
    for (int axis = 0; axis < 3; ++axis) {
      const float extent = centroids.hi[axis] - centroids.lo[axis];
      const float s = static_cast<float>(kBins) * 0.99999f / extent;
      if (extent > 0.0f && std::isfinite(s)) scale[axis] = s;
    }
    origin[3] = 0.0f;
  }
  Int4 operator()(Float4 centroid) const {
    return __builtin_convertvector((centroid - origin) * scale, Int4);
  }
};

struct Plane {
  int axis = -1;
  int bin = 0;  // the first one of the right side
  Box bounds[2];
};

void fill(Bins& bins, std::span<const Primitive> range, const BinMap& map) {
  for (const Primitive& primitive : range) {
    const Box box = load_box(primitive);
    const Int4 bin = map(box.half_centre());
    for (int axis = 0; axis < 3; ++axis) {
      bins.box[axis][bin[axis]].grow(box);
      ++bins.count[axis][bin[axis]];
    }
  }
}

// The cheapest plane of one axis, if it costs less than `best_cost`.
void search_axis(const Bins& bins, int axis, float& best_cost, Plane& best) {
  float right_cost[kBins];
  Box right[kBins];
  Box box;
  std::uint32_t count = 0;
  for (int i = kBins - 1; i > 0; --i) {
    box.grow(bins.box[axis][i]);
    count += bins.count[axis][i];
    right[i] = box;
    right_cost[i] = count == 0 ? kInfinity : box.half_area() * static_cast<float>(count);
  }
  box = Box();
  count = 0;
  for (int i = 1; i < kBins; ++i) {
    box.grow(bins.box[axis][i - 1]);
    count += bins.count[axis][i - 1];
    if (count == 0) continue;
    const float cost = box.half_area() * static_cast<float>(count) + right_cost[i];
    if (cost < best_cost) {
      best_cost = cost;
      best = {axis, i, {box, right[i]}};
    }
  }
}

Plane search(const Bins& bins) {
  float best_cost = kInfinity;
  Plane best;
  for (int axis = 0; axis < 3; ++axis) search_axis(bins, axis, best_cost, best);
  return best;
}

// Partitions in place and gathers the centroid bounds of both sides on the way. Which side comes
// next cannot be foretold, so nothing branches on it: every primitive changes places with the first
// one known to be right (or itself), and each side's bounds take in a point that cannot widen them
// where the primitive is not theirs.
Parts partition(std::span<Primitive> range, const BinMap& map, const Plane& plane) {
  Parts parts;
  std::size_t left = 0;
  const Float4 none = broadcast(kInfinity);
  for (std::size_t i = 0; i < range.size(); ++i) {
    const Primitive moved = range[i];
    const Float4 centre = load_box(moved).half_centre();
    const bool goes_left = map(centre)[plane.axis] < plane.bin;
    const Int4 is_left = Int4{} - static_cast<std::int32_t>(goes_left);
    range[i] = range[left];
    range[left] = moved;
    left += goes_left ? 1 : 0;
    for (int side = 0; side < 2; ++side) {
      const Int4 counts = side == 0 ? is_left : ~is_left;
      Box& box = parts.centroids[side];
      box.lo = min4(box.lo, counts ? centre : none);
      box.hi = max4(box.hi, counts ? centre : -none);
    }
  }
  parts.left_count = static_cast<std::uint32_t>(left);
  parts.bounds[0] = plane.bounds[0];
  parts.bounds[1] = plane.bounds[1];
  return parts;
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
  std::vector<Bins> partial(chunks.count);
  tbb::parallel_for(std::size_t{0}, chunks.count, [&](std::size_t i) {
    fill(partial[i], range.subspan(chunks.begin(i), chunks.end(i) - chunks.begin(i)), map);
  });
  for (std::size_t i = 1; i < partial.size(); ++i) partial[0].merge(partial[i]);
  return partial[0];
}

struct Interval {
  std::size_t begin, end;
};

// Swaps the n-th element of `a` with the n-th of `b`, over lists of as many elements in all.
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

// Partitions each chunk, then swaps what lies on the wrong side of the common middle.
Parts partition_parallel(std::span<Primitive> range, const BinMap& map, const Plane& plane,
                         const Chunks& chunks) {
  std::vector<Parts> partial(chunks.count);
  tbb::parallel_for(std::size_t{0}, chunks.count, [&](std::size_t i) {
    const std::size_t begin = chunks.begin(i);
    partial[i] = partition(range.subspan(begin, chunks.end(i) - begin), map, plane);
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
  const BinMap map(centroids);
  if (range.size() >= kParallelCount) {
    const Chunks chunks(range.size());
    const Plane plane = search(fill_parallel(range, map, chunks));
    if (plane.axis < 0) return std::nullopt;
    return partition_parallel(range, map, plane, chunks);
  }
  Bins bins;
  fill(bins, range, map);
  const Plane plane = search(bins);
  if (plane.axis < 0) return std::nullopt;
  return partition(range, map, plane);
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
