// Tests that a hit depends only on the ray. The same rays in other packets and bundles, and one by
// one, get the same bits. The rays are those for which rounding is worst: ground far from the
// origin, and rays level with it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "reference_meshes.hpp"
#include "tracing.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kBundle = 64;
/// The number of bundles for each kind of rays.
constexpr std::size_t kBundles = 640;
constexpr std::uint32_t kCells = 160;
/// The distance from the middle to the border in metres.
constexpr float kHalf = 20000.0f;

float uniform(std::mt19937& random, float lo, float hi) {
  return std::uniform_real_distribution<float>(lo, hi)(random);
}

/// Returns hills whose cells grow from about 10 m in the middle to 1 km at the border. Some hills
/// are steep.
mesh::GridMesh far_ground() {
  std::vector<float> lines = grid_lines(kCells);
  for (float& line : lines) line *= kHalf * std::fabs(line) + 400.0f;
  std::sort(lines.begin(), lines.end());
  mesh::GridMesh grid(lines, lines);
  std::mt19937 random(61);
  for (std::uint32_t j = 0; j <= kCells; ++j) {
    for (std::uint32_t i = 0; i <= kCells; ++i) {
      const float x = lines[i], z = lines[j];
      const float hills = 300.0f * std::sin(x * 7e-4f) * std::cos(z * 9e-4f);
      const float wide = lines[std::min(i + 1, kCells)] - lines[std::max(i, 1u) - 1];
      grid.set(i, j, hills + 0.1f * wide * uniform(random, -1.0f, 1.0f), vec3(0.0f, 1.0f, 0.0f));
    }
  }
  return grid;
}

/// Returns a point on a triangle of the ground, lifted as a renderer lifts it.
vec3 on_ground(const mesh::GridMesh& grid, std::mt19937& random, std::uint32_t i, std::uint32_t j) {
  float u = uniform(random, 0.0f, 1.0f), v = uniform(random, 0.0f, 1.0f);
  if (u + v > 1.0f) {
    u = 1.0f - u;
    v = 1.0f - v;
  }
  const vec3 a = grid.position(i, j), b = grid.position(i + 1, j), c = grid.position(i, j + 1);
  const vec3 p = a + u * (b - a) + v * (c - a);
  const float largest = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  return p + vec3(0.0f, 1e-4f + 1e-6f * largest, 0.0f);
}

/// Returns a ray in the plane of a triangle with a corner at `a`. It goes through a point of the
/// triangle and may hit another triangle before.
Ray edge_on(std::mt19937& random, const vec3& a, const vec3& b, const vec3& c) {
  const float u = uniform(random, 0.1f, 0.5f), v = uniform(random, 0.1f, 0.5f);
  const vec3 through = a + u * (b - a) + v * (c - a);
  const vec3 along = glm::normalize(uniform(random, -1.0f, 1.0f) * glm::normalize(b - a) +
                                    uniform(random, -1.0f, 1.0f) * glm::normalize(c - a));
  const float way = glm::length(b - a) * std::pow(10.0f, uniform(random, -1.0f, 1.5f));
  Ray ray{through - way * along, along};
  if (random() % 2 == 0) ray.t_max = way * uniform(random, 0.5f, 1.5f);
  return ray;
}

/// A kind of rays. All rays of a bundle start near cell (i, j).
struct Kind {
  const char* name;
  std::function<Ray(std::mt19937&, const vec3& start, const vec3& common)> ray;
};

std::vector<Kind> kinds() {
  return {
      {"ambient",
       [](std::mt19937& random, const vec3& start, const vec3&) {
         const vec3 up = random_direction(random) + vec3(0.0f, 1.01f, 0.0f);
         return Ray{start, glm::normalize(up), std::pow(10.0f, uniform(random, -1.0f, 3.0f))};
       }},
      {"level",
       [](std::mt19937& random, const vec3& start, const vec3&) {
         vec3 direction = random_direction(random);
         direction.y = 0.05f * uniform(random, -1.0f, 1.0f);
         return Ray{start, glm::normalize(direction)};
       }},
      {"sun",
       [](std::mt19937& random, const vec3& start, const vec3& common) {
         return Ray{start, glm::normalize(common + 0.005f * random_point(random, 1.0f))};
       }},
      {"eye",
       [](std::mt19937& random, const vec3& start, const vec3& common) {
         const vec3 eye = vec3(60.0f, 900.0f, -40.0f) + 10.0f * common;
         return ray_towards(eye, dvec3(start + 20.0f * random_point(random, 1.0f)));
       }},
      {"nearly along an axis",
       [](std::mt19937& random, const vec3& start, const vec3& common) {
         const auto tilt = [&] {
           const float size = std::pow(10.0f, uniform(random, -7.0f, -4.5f));
           return random() % 2 == 0 ? size : -size;
         };
         const vec3 direction =
             common.x > 0.0f ? vec3(1.0f, tilt(), tilt()) : vec3(tilt(), 0.01f, 1.0f);
         return Ray{start, glm::normalize(direction)};
       }},
      {"edge-on", nullptr},
  };
}

std::vector<Ray> rays_of(const Kind& kind, const mesh::GridMesh& grid) {
  std::mt19937 random(62);
  std::vector<Ray> rays;
  for (std::size_t b = 0; b < kBundles; ++b) {
    const auto i = static_cast<std::uint32_t>(random() % (kCells - 4));
    const auto j = static_cast<std::uint32_t>(random() % (kCells - 4));
    const vec3 common = glm::normalize(random_direction(random) + vec3(0.0f, 0.3f, 0.0f));
    for (std::size_t k = 0; k < kBundle; ++k) {
      const auto di = static_cast<std::uint32_t>(random() % 4);
      const auto dj = static_cast<std::uint32_t>(random() % 4);
      const std::uint32_t ci = i + di, cj = j + dj;
      rays.push_back(kind.ray ? kind.ray(random, on_ground(grid, random, ci, cj), common)
                              : edge_on(random, grid.position(ci, cj), grid.position(ci + 1, cj),
                                        grid.position(ci, cj + 1)));
      if (k % 19 == 0) rays.back().t_max = -1.0f;
    }
  }
  return rays;
}

using Order = std::vector<std::size_t>;

/// Returns three orders: the original one, a random one within each bundle, and a random one of all
/// rays.
std::vector<Order> orders(std::size_t count) {
  std::mt19937 random(63);
  Order straight(count);
  std::iota(straight.begin(), straight.end(), std::size_t{0});
  Order in_bundles = straight, anywhere = straight;
  for (std::size_t b = 0; b < count; b += kBundle) {
    std::shuffle(in_bundles.begin() + static_cast<std::ptrdiff_t>(b),
                 in_bundles.begin() + static_cast<std::ptrdiff_t>(b + kBundle), random);
  }
  std::shuffle(anywhere.begin(), anywhere.end(), random);
  return {straight, in_bundles, anywhere};
}

/// Traces rays in another order and returns their hits in the original order.
std::vector<Hit> traced(const TracedMesh& mesh, const std::vector<Ray>& rays, const Order& order,
                        int lanes, Wanted wanted) {
  std::vector<Ray> turned;
  turned.reserve(rays.size());
  for (const std::size_t i : order) turned.push_back(rays[i]);
  const std::vector<Hit> found = mesh.trace_bundles(turned, lanes, wanted);
  std::vector<Hit> hits(rays.size());
  for (std::size_t i = 0; i < order.size(); ++i) hits[order[i]] = found[i];
  return hits;
}

bool same(const Hit& a, const Hit& b, Wanted wanted) {
  if (wanted != Wanted::nearest) return a.met() == b.met();
  return a.t == b.t && a.u == b.u && a.v == b.v && a.slot == b.slot && a.instance == b.instance;
}

/// Returns the number of rays whose hit in a bundle differs from that of the ray alone at one lane.
std::size_t different(const TracedMesh& mesh, const std::vector<Ray>& rays, int lanes,
                      Wanted wanted) {
  const std::vector<Hit> alone = mesh.trace(rays, 1, wanted);
  std::size_t count = 0, met = 0;
  for (const Order& order : orders(rays.size())) {
    const std::vector<Hit> hits = traced(mesh, rays, order, lanes, wanted);
    for (std::size_t i = 0; i < rays.size(); ++i) count += same(hits[i], alone[i], wanted) ? 0 : 1;
  }
  for (const Hit& hit : alone) met += hit.met() ? 1 : 0;
  EXPECT_GT(met, rays.size() / 100);
  return count;
}

class Grouping : public LaneTest {};

TEST_P(Grouping, ChangesNoHitOnTheGround) {
  const mesh::GridMesh ground = far_ground();
  const TracedMesh mesh(ground);
  for (const Kind& kind : kinds()) {
    const std::vector<Ray> rays = rays_of(kind, ground);
    for (const Wanted wanted : {Wanted::nearest, Wanted::any, Wanted::any_from_above}) {
      EXPECT_EQ(different(mesh, rays, GetParam(), wanted), 0u)
          << kind.name << ", wanted " << static_cast<int>(wanted);
    }
  }
}

TEST_P(Grouping, ChangesNoHitOnTheGroundAsASoup) {
  const mesh::GridMesh ground = far_ground();
  const mesh::TriangleMesh triangles = mesh::to_triangles(ground);
  const TracedMesh mesh(Soup{triangles.positions, triangles.triangles});
  for (const Kind& kind : kinds()) {
    const std::vector<Ray> rays = rays_of(kind, ground);
    for (const Wanted wanted : {Wanted::nearest, Wanted::any}) {
      EXPECT_EQ(different(mesh, rays, GetParam(), wanted), 0u)
          << kind.name << ", wanted " << static_cast<int>(wanted);
    }
  }
}

// Tests models whose faces lie in the faces of their boxes, seen from kilometres away and from
// within.
TEST_P(Grouping, ChangesNoHitOnInstances) {
  std::mt19937 random(64);
  std::vector<AeroInstance> instances;
  for (int i = 0; i < 300; ++i) {
    instances.push_back(random_instance(random, 30.0f, static_cast<std::uint32_t>(i % 2)));
    instances.back().position[0] += 9000.0f;
    instances.back().position[2] -= 12000.0f;
  }
  Soup own = sphere(16);
  for (vec3& v : own.positions) v = 3.0f * v + vec3(9000.0f, 0.0f, -12000.0f);
  const TracedMesh mesh(own, {random_soup(200, 65), subdivided_box(3)}, instances);
  std::vector<Ray> rays;
  for (std::size_t b = 0; b < kBundles; ++b) {
    const bool far = b % 2 == 0;
    const vec3 middle = vec3(9000.0f, 0.0f, -12000.0f) + random_point(random, 25.0f);
    const vec3 eye = far ? random_point(random, 100.0f) : middle + random_point(random, 40.0f);
    for (std::size_t k = 0; k < kBundle; ++k) {
      const vec3 from = b % 4 < 2 ? eye : eye + random_point(random, 5.0f);
      rays.push_back(ray_towards(from, dvec3(middle + random_point(random, far ? 6.0f : 30.0f))));
      if (k % 19 == 0) rays.back().t_max = -1.0f;
    }
  }
  for (const Wanted wanted : {Wanted::nearest, Wanted::any}) {
    EXPECT_EQ(different(mesh, rays, GetParam(), wanted), 0u) << static_cast<int>(wanted);
  }
}

AEROSTAT_AT_EVERY_WIDTH(Grouping);

}  // namespace
}  // namespace aerostat::test
