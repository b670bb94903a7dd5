// Tests instances of models against the same triangles in one soup.
#include <cmath>
#include <random>

#include "closed_meshes.hpp"
#include "reference_meshes.hpp"
#include "tracing.hpp"

namespace aerostat::test {
namespace {

Soup flattened(const Soup& own, const std::vector<Soup>& models,
               const std::vector<AeroInstance>& instances) {
  Soup all = own;
  for (const AeroInstance& instance : instances) {
    const auto base = static_cast<std::uint32_t>(all.positions.size());
    const Soup& model = models[instance.root];
    for (const vec3& v : model.positions) all.positions.push_back(placed(instance, v));
    for (const uvec3& t : model.triangles) all.triangles.push_back(t + base);
  }
  return all;
}

/// A sphere of the world itself, and instances of two models around it.
struct Orchard {
  explicit Orchard(std::size_t count) {
    std::mt19937 random(41);
    for (std::size_t i = 0; i < count; ++i)
      instances.push_back(random_instance(random, 4.0f, static_cast<std::uint32_t>(i % 2)));
  }

  Soup own = sphere(16);
  std::vector<Soup> models{random_soup(300, 42), icosphere(2)};
  std::vector<AeroInstance> instances;
};

std::vector<Ray> rays_into(std::size_t bundles) {
  std::mt19937 random(43);
  std::vector<Ray> rays;
  for (std::size_t b = 0; b < bundles; ++b) {
    const vec3 eye = random_point(random, 8.0f);
    const vec3 middle = random_point(random, 3.0f);
    for (int k = 0; k < 64; ++k) {
      const vec3 target =
          b % 3 == 0 ? random_point(random, 4.0f) : middle + 0.3f * random_point(random, 1.0f);
      rays.push_back(
          ray_towards(b % 3 == 2 ? eye + 0.2f * random_point(random, 1.0f) : eye, dvec3(target)));
      if (k % 13 == 0) rays.back().t_max = k % 2 == 0 ? -1.0f : 6.0f;
    }
  }
  return rays;
}

/// Returns rays through the models. A third of them lie across one axis of a model, or across two.
std::vector<Ray> rays_along_axes(const Orchard& orchard) {
  std::mt19937 random(44);
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < 64 * orchard.instances.size(); ++i) {
    const AeroInstance& instance = orchard.instances[i / 64];
    const vec3 through = placed(instance, random_point(random, 0.7f));
    vec3 direction = random_direction(random);
    if (i % 3 == 0) {
      vec3 in_model(0.0f);
      in_model[static_cast<int>(i / 3 % 3)] = 1.0f;
      if (i % 2 == 0) in_model[static_cast<int>(i / 9 % 3)] += 0.7f;
      direction = glm::normalize(placed(instance, in_model) - placed(instance, vec3(0.0f)));
    }
    Ray ray = ray_towards(through - 9.0f * direction, dvec3(through));
    if (i % 3 == 0) ray.direction = direction;
    rays.push_back(ray);
  }
  return rays;
}

class Instances : public LaneTest {};

TEST_P(Instances, AreMetWhereTheirTrianglesWouldBe) {
  const Orchard orchard(150);
  const TracedMesh traced(orchard.own, orchard.models, orchard.instances);
  const TracedMesh reference(flattened(orchard.own, orchard.models, orchard.instances));
  const std::vector<Ray> rays = rays_into(60);
  for (const bool bundles : {true, false}) {
    const auto ask = [&](const TracedMesh& mesh, Wanted wanted) {
      return bundles ? mesh.trace_bundles(rays, GetParam(), wanted)
                     : mesh.trace(rays, GetParam(), wanted);
    };
    const auto hits = ask(traced, Wanted::nearest), expected = ask(reference, Wanted::nearest);
    const auto any = ask(traced, Wanted::any);
    std::size_t in_instances = 0, own = 0, edges = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      // At silhouettes the two may round to different sides.
      if (hits[i].met() != expected[i].met() ||
          (hits[i].met() && std::fabs(hits[i].t - expected[i].t) > 2e-4f)) {
        ++edges;
        continue;
      }
      ASSERT_EQ(any[i].met(), hits[i].met()) << "ray " << i;
      if (!hits[i].met()) continue;
      const bool placed_hit = hits[i].instance != kNoTriangle;
      in_instances += placed_hit ? 1 : 0;
      own += placed_hit ? 0 : 1;
      if (placed_hit) {
        ASSERT_LT(hits[i].instance, orchard.instances.size());
        const AeroInstance& instance = orchard.instances[hits[i].instance];
        const AeroTriangle& triangle = traced.triangles()[hits[i].slot];
        const vec3 a(triangle.v0[0], triangle.v0[1], triangle.v0[2]);
        const vec3 b(triangle.v1[0], triangle.v1[1], triangle.v1[2]);
        const vec3 c(triangle.v2[0], triangle.v2[1], triangle.v2[2]);
        const float u = hits[i].u, v = hits[i].v;
        const vec3 p = placed(instance, (1.0f - u - v) * a + u * b + v * c);
        ASSERT_LT(glm::distance(p, rays[i].origin + hits[i].t * rays[i].direction), 1e-3f) << i;
      }
    }
    EXPECT_GT(in_instances, rays.size() / 10);
    EXPECT_GT(own, 5u);
    EXPECT_LT(edges, rays.size() / 500);
  }
}

TEST_P(Instances, HitsDoNotDependOnTheirBundle) {
  const Orchard orchard(60);
  const TracedMesh traced(orchard.own, orchard.models, orchard.instances);
  for (const std::vector<Ray>& rays : {rays_into(30), rays_along_axes(orchard)}) {
    const auto together = traced.trace_bundles(rays, GetParam()), alone = traced.trace(rays, 1);
    std::size_t in_instances = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      ASSERT_EQ(together[i].t, alone[i].t) << i;
      ASSERT_EQ(together[i].slot, alone[i].slot) << i;
      ASSERT_EQ(together[i].instance, alone[i].instance) << i;
      in_instances += together[i].instance != kNoTriangle ? 1 : 0;
    }
    EXPECT_GT(in_instances, rays.size() / 10);
  }
}

AEROSTAT_AT_EVERY_WIDTH(Instances);

}  // namespace
}  // namespace aerostat::test
