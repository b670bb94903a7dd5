#include "loops.hpp"

#include "partition.hpp"
#include "small_tree.hpp"

namespace aerostat::bvh {
namespace {

#define AEROSTAT_DEFINE_LOOPS(NAME, TARGET, WIDE)                                              \
  TARGET void fill_##NAME(Bins& bins, const Primitive* first, std::size_t count,               \
                          const BinMap& map) {                                                 \
    fill_bins<WIDE>(bins, first, count, map);                                                  \
  }                                                                                            \
  TARGET Plane search_##NAME(const Bins& bins, Box(&bounds)[2]) {                              \
    const Plane plane = search_plane<WIDE>(bins);                                              \
    if (plane.axis >= 0) bound_sides<WIDE>(bins, plane, bounds);                               \
    return plane;                                                                              \
  }                                                                                            \
  TARGET std::size_t partition_##NAME(Primitive* first, std::size_t count, const BinMap& map,  \
                                      const Plane& plane, Box(&centroids)[2]) {                \
    return partition<WIDE>(first, count, map, plane, centroids);                               \
  }                                                                                            \
  TARGET void build_small_##NAME(Primitive* first, int count, BinaryNode* nodes, int depth,    \
                                 const BuildOptions& options, Forest& forest) {                \
    SmallTree<WIDE> tree(first, count);                                                        \
    tree.part(depth);                                                                          \
    tree.cost(options, nodes, forest);                                                         \
    tree.reorder(first);                                                                       \
  }                                                                                            \
  TARGET void combine_##NAME(const Forest& left, const Forest& right, float area,              \
                             std::uint32_t count, const BuildOptions& options, Forest& forest, \
                             Plan& plan) {                                                     \
    forest = combine(left, right, area, count, options, plan);                                 \
  }                                                                                            \
  constexpr Loops k##NAME{fill_##NAME, search_##NAME, partition_##NAME, build_small_##NAME,    \
                          combine_##NAME};

AEROSTAT_DEFINE_LOOPS(Plain, , false)
AEROSTAT_DEFINE_LOOPS(Avx2, AEROSTAT_FOR_AVX2, true)
AEROSTAT_DEFINE_LOOPS(Avx512, AEROSTAT_FOR_AVX512, true)

constexpr const Loops* kAll[] = {&kPlain, &kAvx2, &kAvx512};

std::size_t widths_here() {
  return widest(std::size_t{1}, std::size_t{2}, std::size_t{3});
}

}  // namespace

const Loops& loops() {
  static const Loops& chosen = *kAll[widths_here() - 1];
  return chosen;
}

std::span<const Loops* const> all_loops() {
  return std::span(kAll).first(widths_here());
}

}  // namespace aerostat::bvh
