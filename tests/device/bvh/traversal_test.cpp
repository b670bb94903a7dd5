// Tests trace_packet against brute force in double precision, and at the exact end of its buffers.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include <sys/mman.h>
#include <unistd.h>

#include "core/error.hpp"
#include "reference_meshes.hpp"
#include "tracing.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kRays = 10000;

class Traversal : public testing::TestWithParam<MeshCase> {};

/// The result of brute force over all triangles. It is not sure if it depends on the rounding of an
/// edge.
struct Expected {
  double t = std::numeric_limits<double>::infinity();
  bool sure = true;
};

Expected brute_force(const std::vector<AeroTriangle>& triangles, const Ray& ray) {
  Expected expected;
  double nearest_doubt = std::numeric_limits<double>::infinity();
  for (const AeroTriangle& triangle : triangles) {
    const ExactHit hit = exact_hit(triangle, ray);
    const double tolerance = weight_tolerance(triangle, ray, hit.t);
    if (hit.slack < -tolerance || hit.t < -1e-4) continue;
    const bool doubtful = hit.slack < tolerance || hit.t < 1e-4;
    if (doubtful) {
      nearest_doubt = std::min(nearest_doubt, hit.t);
    } else if (hit.t <= static_cast<double>(ray.t_max)) {
      expected.t = std::min(expected.t, hit.t);
    }
  }
  expected.sure = std::isinf(nearest_doubt) || nearest_doubt > expected.t * 1.0001 + 1e-4;
  return expected;
}

TEST_P(Traversal, FindsWhatBruteForceFinds) {
  const TracedMesh mesh(GetParam().soup());
  ASSERT_LE(mesh.tree().stats.stack_entries, static_cast<unsigned>(AERO_BVH_STACK));
  const std::vector<Ray> rays = GetParam().rays(kRays, 59);
  std::vector<Expected> expected;
  for (const Ray& ray : rays) expected.push_back(brute_force(mesh.triangles(), ray));
  for (const int lanes : {1, 4, 8, 16}) {
    const std::vector<Hit> hits = mesh.trace(rays, lanes);
    const std::vector<Hit> shadows = mesh.trace(rays, lanes, Wanted::any);
    std::size_t wrong = 0, met = 0, sure = 0, contrary = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      contrary += hits[i].met() != shadows[i].met() ? 1 : 0;
      contrary += shadows[i].met() && shadows[i].t < hits[i].t ? 1 : 0;
      if (!expected[i].sure) continue;
      ++sure;
      met += hits[i].met() ? 1 : 0;
      const bool should_meet = std::isfinite(expected[i].t);
      const double off = std::abs(static_cast<double>(hits[i].t) - expected[i].t);
      wrong += hits[i].met() != should_meet || (should_meet && off > 1e-4 * expected[i].t + 1e-6);
    }
    EXPECT_EQ(wrong, 0u) << "of " << sure << " at " << lanes << " lanes";
    EXPECT_EQ(contrary, 0u) << "shadow rays that disagree at " << lanes << " lanes";
    EXPECT_GT(sure, kRays * 9 / 10);
    EXPECT_GT(met, GetParam().fewest_hits);
  }
}

TEST_P(Traversal, GivesTheSameBitsAtEveryWidth) {
  const TracedMesh mesh(GetParam().soup());
  const std::vector<Ray> rays = GetParam().rays(4096, 60);
  const std::vector<Hit> narrow = mesh.trace(rays, 1);
  for (const int lanes : {4, 8, 16}) {
    const std::vector<Hit> wide = mesh.trace(rays, lanes);
    std::size_t different = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      different += wide[i].slot != narrow[i].slot || wide[i].t != narrow[i].t ||
                   wide[i].u != narrow[i].u || wide[i].v != narrow[i].v;
    }
    EXPECT_EQ(different, 0u) << lanes << " lanes";
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Traversal, testing::ValuesIn(reference_meshes()),
                         [](const auto& test) { return std::string(test.param.name); });

class Packets : public LaneTest {};

TEST_P(Packets, TreatEveryLaneByItself) {
  // Some lanes are off, too short, or look away, beside lanes that hit.
  const TracedMesh mesh(sphere(24));
  std::vector<Ray> rays;
  for (int i = 0; i < 256; ++i) {
    const float towards = i % 4 == 3 ? -1.0f : 1.0f;
    const float reach = i % 4 == 1 ? -1.0f : i % 4 == 2 ? 1.5f : kInfinity;
    rays.push_back({{0.01f, 0.02f, 3.0f}, {0.0f, 0.0f, -towards}, reach});
  }
  const std::vector<Hit> hits = mesh.trace(rays, GetParam());
  for (std::size_t i = 0; i < rays.size(); ++i) ASSERT_EQ(hits[i].met(), i % 4 == 0) << i;
}

TEST_P(Packets, LeaveAnEmptyTreeAlone) {
  const bvh::Bvh tree = bvh::build({}, {});
  ASSERT_EQ(tree.nodes.size(), 1u);
  Soup nothing;
  const TracedMesh mesh(nothing);
  for (const Hit& hit : mesh.trace(std::vector<Ray>(16, Ray{{0, 0, 0}, {0, 0, 1}}), GetParam())) {
    EXPECT_FALSE(hit.met());
    EXPECT_EQ(hit.t, kInfinity);
  }
}

/// Host memory that ends at a page which nobody may access.
class GuardedBytes {
 public:
  template <typename T>
  explicit GuardedBytes(const std::vector<T>& values) : bytes_(values.size() * sizeof(T)) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    whole_ = (bytes_ + page - 1) / page * page;
    void* mapped =
        mmap(nullptr, whole_ + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) throw Error(ErrorKind::exhausted, "no memory for a guard page");
    base_ = static_cast<std::byte*>(mapped);
    mprotect(base_ + whole_, page, PROT_NONE);
    std::memcpy(start(), values.data(), bytes_);
    total_ = whole_ + page;
  }
  GuardedBytes(const GuardedBytes&) = delete;
  GuardedBytes& operator=(const GuardedBytes&) = delete;
  ~GuardedBytes() { munmap(base_, total_); }

  /// Returns a buffer of the bytes themselves. It must not outlive this object.
  opencl::RawBuffer buffer() const {
    return {context(), {}, nullptr, start(), bytes_, "guarded bytes"};
  }

 private:
  std::byte* start() const { return base_ + (whole_ - bytes_); }

  std::byte* base_ = nullptr;
  std::size_t bytes_ = 0, whole_ = 0, total_ = 0;
};

// Tests reads near the ends of buffers. On a device that works in host memory, reading past the end
// ends this process.
TEST_P(Packets, ReadNothingBeyondTheirBuffers) {
  const Soup soup = random_soup(3001, 61);
  const TracedMesh mesh(soup);
  const GuardedBytes nodes(mesh.tree().nodes), triangles(mesh.triangles());
  std::mt19937 random(62);
  std::vector<Ray> rays;
  for (int i = 0; i < 4096; ++i) {
    rays.push_back(ray_towards(random_point(random, 2.0f), dvec3(random_point(random, 1.0f))));
  }
  const RayBuffers buffers(rays);
  {
    const opencl::RawBuffer node_buffer = nodes.buffer(), triangle_buffer = triangles.buffer();
    Probe("trace.cl", GetParam())
        .run("probe_trace", buffers.elements, node_buffer, triangle_buffer,
             input(std::vector<AeroInstance>()), input(no_grid()), buffers.origins,
             buffers.directions, buffers.t_max, 0, buffers.tuv, buffers.slots);
  }
  const std::vector<Hit> guarded = buffers.hits(rays.size());
  const std::vector<Hit> plain = mesh.trace(rays, GetParam());
  for (std::size_t i = 0; i < rays.size(); ++i) ASSERT_EQ(guarded[i].slot, plain[i].slot);
}

TEST_P(Packets, ReadNothingBeyondAGrid) {
  const std::vector<float> lines{-1.0f, -0.6f, -0.3f, 0.0f, 0.2f, 0.5f, 1.0f};
  mesh::GridMesh grid(lines, lines);
  for (std::uint32_t v = 0; v < 49; ++v)
    grid.set(v % 7, v / 7, 0.1f * static_cast<float>(v * 37 % 11), vec3(0.0f, 1.0f, 0.0f));
  const TracedMesh mesh(grid);
  const GuardedBytes nodes(mesh.tree().nodes);
  const GuardedBytes words(std::vector<float>(grid.words().begin(), grid.words().end()));
  std::mt19937 random(63);
  std::vector<Ray> rays;
  for (int i = 0; i < 4096; ++i) {
    rays.push_back(ray_towards(random_point(random, 3.0f), dvec3(random_point(random, 1.0f))));
  }
  for (const Wanted wanted : {Wanted::nearest, Wanted::any_from_above}) {
    const RayBuffers buffers(rays);
    {
      const opencl::RawBuffer node_buffer = nodes.buffer(), word_buffer = words.buffer();
      Probe("trace.cl", GetParam())
          .run("probe_trace", buffers.elements, node_buffer, input(std::vector<AeroTriangle>()),
               input(std::vector<AeroInstance>()), word_buffer, buffers.origins, buffers.directions,
               buffers.t_max, static_cast<std::int32_t>(wanted), buffers.tuv, buffers.slots);
    }
    const std::vector<Hit> guarded = buffers.hits(rays.size());
    const std::vector<Hit> plain = mesh.trace(rays, GetParam(), wanted);
    std::size_t met = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      ASSERT_EQ(guarded[i].slot, plain[i].slot);
      met += plain[i].met() ? 1 : 0;
    }
    EXPECT_GT(met, 500u);
  }
}

AEROSTAT_AT_EVERY_WIDTH(Packets);

}  // namespace
}  // namespace aerostat::test
