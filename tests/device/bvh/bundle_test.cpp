// Tests that packets that are traced together give every ray the same hit as the ray alone.
#include <cmath>
#include <functional>

#include "reference_meshes.hpp"
#include "tracing.hpp"

namespace aerostat::test {
namespace {

/// The number of rays in a bundle. It is four packets of the widest kind.
constexpr std::size_t kBundle = 64;
constexpr int kBundles = 64;

/// The rays of a bundle, in and around a mesh of extent `scale` at `offset`.
struct Pattern {
  const char* name;
  std::function<Ray(std::mt19937&, const MeshCase&, const vec3& eye, const vec3& aim)> ray;
};

vec3 jitter(std::mt19937& random, float size) {
  return random_point(random, size);
}

std::vector<Pattern> patterns() {
  return {
      {"common_origin",
       [](std::mt19937& random, const MeshCase& mesh, const vec3& eye, const vec3& aim) {
         return ray_towards(eye, dvec3(aim + jitter(random, 0.1f * mesh.scale)));
       }},
      {"common_direction",
       [](std::mt19937& random, const MeshCase& mesh, const vec3& eye, const vec3& aim) {
         return Ray{eye + jitter(random, 0.1f * mesh.scale), glm::normalize(aim - eye)};
       }},
      {"mixed_signs",
       [](std::mt19937& random, const MeshCase& mesh, const vec3&, const vec3& aim) {
         return ray_towards(mesh.offset + random_point(random, 2.0f * mesh.scale),
                            dvec3(aim + jitter(random, 0.3f * mesh.scale)));
       }},
      {"along_an_axis",
       [](std::mt19937& random, const MeshCase& mesh, const vec3& eye, const vec3& aim) {
         vec3 direction(0.0f);
         const int axis = static_cast<int>(random() % 3);
         direction[axis] = aim[axis] >= eye[axis] ? 1.0f : -1.0f;
         return Ray{aim - direction * (2.0f * mesh.scale) + jitter(random, 0.2f * mesh.scale),
                    direction};
       }},
      {"nearly_along_an_axis",
       [](std::mt19937& random, const MeshCase& mesh, const vec3&, const vec3& aim) {
         const auto tilt = [&] {
           return std::pow(10.0f, std::uniform_real_distribution<float>(-6.5f, -3.5f)(random));
         };
         const vec3 direction = glm::normalize(vec3(tilt(), -1.0f, tilt()));
         return Ray{aim - direction * (2.0f * mesh.scale) + jitter(random, 0.2f * mesh.scale),
                    direction};
       }},
      {"from_inside",
       [](std::mt19937& random, const MeshCase& mesh, const vec3&, const vec3&) {
         return Ray{mesh.offset + random_point(random, 0.7f * mesh.scale),
                    random_direction(random)};
       }},
      {"some_off_some_short",
       [](std::mt19937& random, const MeshCase& mesh, const vec3& eye, const vec3& aim) {
         Ray ray = ray_towards(eye, dvec3(aim + jitter(random, 0.1f * mesh.scale)));
         const unsigned kind = static_cast<unsigned>(random() % 4);
         if (kind == 0) ray = {vec3(0.0f), vec3(0.0f), -1.0f};
         if (kind == 1) ray.t_max = mesh.scale;
         return ray;
       }},
  };
}

std::vector<Ray> bundles(const MeshCase& mesh, const Pattern& pattern) {
  std::mt19937 random(91);
  std::vector<Ray> rays;
  for (int b = 0; b < kBundles; ++b) {
    const vec3 eye = mesh.offset + random_point(random, 2.0f * mesh.scale);
    const vec3 aim = mesh.offset + random_point(random, 0.6f * mesh.scale);
    for (std::size_t i = 0; i < kBundle; ++i) rays.push_back(pattern.ray(random, mesh, eye, aim));
    // One packet is switched off as a whole beside others.
    if (b % 8 == 3) {
      for (std::size_t i = 16; i < 32; ++i) rays[rays.size() - kBundle + i].t_max = -1.0f;
    }
  }
  return rays;
}

/// Returns the nearest hits among all triangles, each tested by itself at one lane, without tree
/// and culling.
std::vector<Hit> brute_force(const TracedMesh& mesh, const std::vector<Ray>& rays) {
  const RayBuffers buffers(rays);
  Probe("trace.cl", 1)
      .run("probe_triangles", buffers.elements, input(mesh.triangles()),
           static_cast<std::uint32_t>(mesh.triangles().size()), buffers.origins, buffers.directions,
           buffers.t_max, 0u, buffers.tuv, buffers.slots);
  return buffers.hits(rays.size());
}

class Bundles : public testing::TestWithParam<MeshCase> {};

TEST_P(Bundles, GiveTheBitsOfBruteForce) {
  const TracedMesh mesh(GetParam().soup());
  std::size_t met = 0;
  for (const Pattern& pattern : patterns()) {
    const std::vector<Ray> rays = bundles(GetParam(), pattern);
    const std::vector<Hit> expected = brute_force(mesh, rays);
    for (const int lanes : {1, 4, 8, 16}) {
      const std::vector<Hit> hits = mesh.trace_bundles(rays, lanes);
      const std::vector<Hit> alone = mesh.trace(rays, lanes);
      const std::vector<Hit> shadows = mesh.trace_bundles(rays, lanes, Wanted::any);
      std::size_t different = 0, alone_different = 0, contrary = 0;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto same = [&](const Hit& hit) {
          return hit.slot == expected[i].slot && hit.t == expected[i].t && hit.u == expected[i].u &&
                 hit.v == expected[i].v;
        };
        different += same(hits[i]) ? 0 : 1;
        alone_different += same(alone[i]) ? 0 : 1;
        contrary += shadows[i].met() != expected[i].met() ? 1 : 0;
        met += hits[i].met() ? 1 : 0;
      }
      EXPECT_EQ(different, 0u) << pattern.name << " at " << lanes << " lanes";
      EXPECT_EQ(alone_different, 0u) << pattern.name << " alone at " << lanes << " lanes";
      EXPECT_EQ(contrary, 0u) << pattern.name << ", shadows at " << lanes << " lanes";
    }
  }
  EXPECT_GE(met, GetParam().fewest_hits);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Bundles, testing::ValuesIn(reference_meshes()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace aerostat::test
