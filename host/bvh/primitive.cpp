#include "primitive.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <tbb/parallel_for.h>

#include "core/error.hpp"

namespace aerostat::bvh {
namespace {

// Blocks have a fixed size, so that nothing depends on the distribution of blocks to threads.
constexpr std::size_t kBlock = 16384;

struct BlockResult {
  std::uint32_t kept = 0;
  std::uint64_t non_finite = 0;
  std::uint64_t degenerate = 0;
  bool bad_index = false;
  Box bounds;
  Box centroids;
};

Box box_of(const vec3& a, const vec3& b, const vec3& c) {
  Box box;
  for (const vec3& v : {a, b, c}) box.grow(Float4{v.x, v.y, v.z, 0.0f});
  return box;
}

class Collector {
 public:
  Collector(std::span<const vec3> positions, std::span<const uvec3> triangles, Primitive* out)
      : positions_(positions), triangles_(triangles), out_(out) {}

  BlockResult run(std::size_t begin, std::size_t end) const {
    BlockResult result;
    for (std::size_t i = begin; i < end; ++i) {
      const uvec3 t = triangles_[i];
      if (std::max({t.x, t.y, t.z}) >= positions_.size()) {
        result.bad_index = true;
        return result;
      }
      add(static_cast<std::uint32_t>(i), out_ + begin, result);
    }
    return result;
  }

 private:
  void add(std::uint32_t i, Primitive* out, BlockResult& result) const {
    const uvec3 t = triangles_[i];
    const vec3 &a = positions_[t.x], &b = positions_[t.y], &c = positions_[t.z];
    switch (judge(a, b, c)) {
      case Verdict::non_finite:
        ++result.non_finite;
        return;
      case Verdict::degenerate:
        ++result.degenerate;
        return;
      case Verdict::good:
        break;
    }
    const Box box = box_of(a, b, c);
    Primitive& primitive = out[result.kept++];
    store_box(primitive, box);
    primitive.triangle = i;
    primitive.unused = 0;
    result.bounds.grow(box);
    result.centroids.grow(box.half_centre());
  }

  std::span<const vec3> positions_;
  std::span<const uvec3> triangles_;
  Primitive* out_;
};

// Closes the gaps that dropped triangles have left at the ends of blocks.
void merge(PrimitiveSet& set, const std::vector<BlockResult>& blocks) {
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const BlockResult& block = blocks[b];
    if (block.bad_index)
      throw Error(ErrorKind::internal,
                  "building a BVH: a triangle between " + std::to_string(b * kBlock) + " and " +
                      std::to_string((b + 1) * kBlock) + " names a vertex that does not exist");
    Primitive* const from = set.items.get() + b * kBlock;
    Primitive* const to = set.items.get() + set.count;
    if (from != to) std::copy(from, from + block.kept, to);
    set.count += block.kept;
    set.non_finite += block.non_finite;
    set.degenerate += block.degenerate;
    set.bounds.grow(block.bounds);
    set.centroids.grow(block.centroids);
  }
}

}  // namespace

Verdict judge(const vec3& a, const vec3& b, const vec3& c) {
  if (!is_finite(a) || !is_finite(b) || !is_finite(c)) return Verdict::non_finite;
  // In double, no product of floats overflows or vanishes, so that only a true zero is zero.
  const dvec3 normal = glm::cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a));
  const bool flat = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
  return flat ? Verdict::degenerate : Verdict::good;
}

void check_input(std::size_t triangles, const BuildOptions& options) {
  constexpr std::size_t kMostTriangles = std::size_t{AERO_BVH_FIRST_MASK} + 1;
  if (options.max_leaf_triangles < 1 || options.max_leaf_triangles > AERO_BVH_MAX_LEAF)
    throw Error(ErrorKind::internal, "building a BVH: max_leaf_triangles is " +
                                         std::to_string(options.max_leaf_triangles) +
                                         ", expected 1 to " + std::to_string(AERO_BVH_MAX_LEAF));
  if (triangles > kMostTriangles)
    throw Error(ErrorKind::bad_data, "building a BVH: " + std::to_string(triangles) +
                                         " triangles, expected at most " +
                                         std::to_string(kMostTriangles));
}

PrimitiveSet collect_primitives(std::span<const vec3> positions, std::span<const uvec3> triangles) {
  PrimitiveSet set;
  set.items = std::make_unique_for_overwrite<Primitive[]>(triangles.size());
  const Collector collector(positions, triangles, set.items.get());
  std::vector<BlockResult> blocks((triangles.size() + kBlock - 1) / kBlock);
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
    blocks[b] = collector.run(b * kBlock, std::min((b + 1) * kBlock, triangles.size()));
  });
  merge(set, blocks);
  return set;
}

}  // namespace aerostat::bvh
