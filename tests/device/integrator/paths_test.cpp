// Rays that are data: a small path tracer follows rays that no eye sent out.
#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "bvh/bvh.hpp"
#include "closed_meshes.hpp"
#include "shading_scene.hpp"
#include "trace_triangle.h"
#include "tracing.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kPaths = 4096;
constexpr std::size_t kWords = 13;  // PATH_RAY_WORDS

/// An even sky of radiance 1 over things of one plain material.
pack::PackedScene bright_scene(const vec3& albedo) {
  AeroScene scene = bare_scene();
  scene.shading = AERO_SHADING_FLAT;
  set3(scene.materials[0].albedo, albedo);
  scene.materials[0].kind = AERO_MATERIAL_PLAIN;
  scene.materials[0].diffuse = 1.0f;
  scene.materials[0].shininess = 1.0f;
  return with_even_sky(scene, vec3(1.0f) / kPi);
}

/// A soup on the device with all that surfaces need. Normals point away from the origin.
struct Things {
  explicit Things(const Soup& soup) {
    const bvh::Bvh tree = bvh::build(soup.positions, soup.triangles);
    std::vector<AeroTriangle> sorted;
    std::vector<AeroFace> sorted_faces;
    std::vector<AeroVertex> attributes;
    for (const std::uint32_t number : tree.order) {
      const uvec3 t = soup.triangles[number];
      AeroTriangle triangle{};
      set3(triangle.v0, soup.positions[t.x]);
      set3(triangle.v1, soup.positions[t.y]);
      set3(triangle.v2, soup.positions[t.z]);
      sorted.push_back(triangle);
      sorted_faces.push_back({{t.x, t.y, t.z}, 3, 0});
    }
    for (const vec3& position : soup.positions) {
      AeroVertex vertex{};
      set3(vertex.position, position);
      set3(vertex.normal, glm::normalize(position));
      set3(vertex.color, vec3(1.0f));
      attributes.push_back(vertex);
    }
    nodes = input(tree.nodes);
    triangles = input(sorted);
    faces = input(sorted_faces);
    vertices = input(attributes);
  }

  opencl::Buffer<AeroBvhNode> nodes;
  opencl::Buffer<AeroTriangle> triangles;
  opencl::Buffer<AeroFace> faces;
  opencl::Buffer<AeroVertex> vertices;
  opencl::Buffer<AeroInstance> instances = input(std::vector<AeroInstance>());
  opencl::Buffer<float> grid = input(no_grid());
};

/// Rays from all around into a ball of the given radius.
std::vector<Ray> rays_into(float radius) {
  std::mt19937 random(31);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  std::vector<Ray> rays;
  while (rays.size() < kPaths) {
    const vec3 target(unit(random), unit(random), unit(random));
    if (glm::length(target) > 1.0f) continue;
    rays.push_back(ray_towards(4.0f * random_direction(random), dvec3(radius * target)));
  }
  return rays;
}

std::vector<std::uint32_t> in_order() {
  std::vector<std::uint32_t> pixels(kPaths);
  for (std::size_t i = 0; i < kPaths; ++i) pixels[i] = static_cast<std::uint32_t>(i);
  return pixels;
}

class Paths : public LaneTest {
 protected:
  const Probe probe{"paths.cl", GetParam()};

  /// Path rays on the device; they are `width` wide and spread by `spread`.
  opencl::Buffer<float> make(const std::vector<Ray>& rays, const std::vector<std::uint32_t>& pixels,
                             float width = 0.0f, float spread = 1e-3f) const {
    auto paths = output<float>(kWords * kPaths);
    const RayBuffers buffers(rays);
    probe.run("probe_make_paths", kPaths, buffers.origins, buffers.directions,
              input(std::vector<float>(kPaths, width)), input(std::vector<float>(kPaths, spread)),
              input(pixels), paths);
    return paths;
  }

  /// Radiance by pixel after some bounces; `paths` goes on from where it was.
  std::vector<vec3> follow(const pack::PackedScene& scene, const Things& things,
                           opencl::Buffer<float>& paths, std::uint32_t bounces) const {
    const auto radiance = input(std::vector<float>(3 * kPaths, 0.0f));
    const UploadedScene on_device(scene);
    for (std::uint32_t bounce = 0; bounce < bounces; ++bounce) {
      probe.run("probe_follow_paths", kPaths, on_device.numbers, on_device.sky_table,
                on_device.cloud_chart, things.nodes, things.triangles, things.instances,
                things.grid, things.faces, things.vertices, bounce, paths, radiance);
    }
    const auto values = radiance.read();
    std::vector<vec3> result;
    for (std::size_t i = 0; i < kPaths; ++i) {
      result.emplace_back(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
    }
    return result;
  }

  /// Word `word` of path `i`, by the order of the fields of PathRay.
  float word_of(const std::vector<float>& paths, std::size_t i, std::size_t word) const {
    const auto lanes = static_cast<std::size_t>(GetParam());
    return paths[(i / lanes * kWords + word) * lanes + i % lanes];
  }
};

// Nothing of a convex body sees another part of it: light is reflected once.
TEST_P(Paths, ReflectOnceOffABall) {
  const vec3 albedo(0.7f, 0.5f, 0.2f);
  const Things ball(icosphere(3));
  const auto rays = rays_into(1.4f);
  auto paths = make(rays, in_order());
  const auto radiance = follow(bright_scene(albedo), ball, paths, 3);
  std::size_t met = 0, missed = 0;
  for (std::size_t i = 0; i < kPaths; ++i) {
    const dvec3 o(rays[i].origin), d(rays[i].direction);
    const double off = glm::length(o - glm::dot(o, d) * d);
    if (off > 0.98 && off < 1.0) continue;  // among the facets of the rim
    const bool hit = off < 1.0;
    (hit ? met : missed) += 1;
    EXPECT_LT(glm::distance(radiance[i], hit ? albedo : vec3(1.0f)), 1e-4f) << i;
  }
  EXPECT_GT(met, kPaths / 4);
  EXPECT_GT(missed, kPaths / 20);
}

/// A box whose lid is off.
Soup open_box() {
  Soup box = subdivided_box(4);
  std::erase_if(box.triangles, [&box](const uvec3& t) {
    return box.positions[t.x].y > 0.99f && box.positions[t.y].y > 0.99f &&
           box.positions[t.z].y > 0.99f;
  });
  return box;
}

// In an even light all of a white thing is as bright as the light, however often it is reflected.
TEST_P(Paths, FindAWhiteBoxAsBrightAsTheSky) {
  auto paths = make(rays_into(1.5f), in_order());
  const auto radiance = follow(bright_scene(vec3(1.0f)), Things(open_box()), paths, 48);
  std::size_t several = 0;
  const auto words = paths.read();
  double sum = 0.0;
  for (std::size_t i = 0; i < kPaths; ++i) {
    sum += static_cast<double>(radiance[i].x);
    several += word_of(words, i, 6) >= 0.0f ? 1 : 0;
  }
  EXPECT_LT(several, kPaths / 200) << "still under way";
  EXPECT_NEAR(sum / static_cast<double>(kPaths), 1.0, 0.005);
}

// A ray's neighbours in its packet do not matter, nor does its place in the buffer.
TEST_P(Paths, AreTheSameInAnyOrder) {
  const Things ball(icosphere(2));
  const auto rays = rays_into(1.2f);
  std::vector<std::uint32_t> shuffled = in_order();
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(5));
  std::vector<Ray> mixed(kPaths);
  for (std::size_t i = 0; i < kPaths; ++i) mixed[i] = rays[shuffled[i]];
  const pack::PackedScene scene = bright_scene({0.5f, 0.6f, 0.7f});
  auto straight = make(rays, in_order()), crossed = make(mixed, shuffled);
  const auto one = follow(scene, ball, straight, 2), other = follow(scene, ball, crossed, 2);
  for (std::size_t i = 0; i < kPaths; ++i) ASSERT_EQ(one[i], other[i]) << i;
}

TEST_P(Paths, CarryTheirConesThroughputAndPixels) {
  constexpr float kWidth = 0.01f, kSpread = 0.02f;
  const vec3 albedo(0.7f, 0.5f, 0.2f);
  const auto rays = rays_into(0.5f);
  auto paths = make(rays, in_order(), kWidth, kSpread);
  follow(bright_scene(albedo), Things(icosphere(3)), paths, 1);
  const auto words = paths.read();
  for (std::size_t i = 0; i < kPaths; ++i) {
    const vec3 origin(word_of(words, i, 0), word_of(words, i, 1), word_of(words, i, 2));
    ASSERT_GE(word_of(words, i, 6), 0.0f) << "goes on";
    ASSERT_NEAR(glm::length(origin), 1.0f, 0.02f);
    const float way = glm::distance(origin, rays[i].origin);
    EXPECT_NEAR(word_of(words, i, 7), kWidth + kSpread * way, 1e-4f) << "width";
    EXPECT_GT(word_of(words, i, 8), kSpread) << "spread";
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(word_of(words, i, 9 + c), albedo[static_cast<int>(c)], 1e-5f) << "throughput";
    }
    EXPECT_EQ(std::bit_cast<std::uint32_t>(word_of(words, i, 12)), i) << "pixel";
  }
}

TEST_P(Paths, LoseLightAtEveryReflection) {
  const vec3 albedo(0.7f, 0.5f, 0.2f);
  auto paths = make(rays_into(0.9f), in_order());
  follow(bright_scene(albedo), Things(open_box()), paths, 3);
  const auto words = paths.read();
  std::size_t on = 0;
  for (std::size_t i = 0; i < kPaths; ++i) {
    if (word_of(words, i, 6) < 0.0f) continue;
    ++on;
    for (std::size_t c = 0; c < 3; ++c) {
      const float share = albedo[static_cast<int>(c)];
      EXPECT_NEAR(word_of(words, i, 9 + c), share * share * share, 1e-5f);
    }
  }
  EXPECT_GT(on, kPaths / 50);
}

AEROSTAT_AT_EVERY_WIDTH(Paths);

}  // namespace
}  // namespace aerostat::test
