#include "soup.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "core/stopwatch.hpp"
#include "model/balloon.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "world/resolve.hpp"

namespace aerostat::bench {
namespace {

constexpr float kExtent = 45.0f;  // half of the soup's side in metres
constexpr int kRopeSides = 6;
// The share of all triangles that are in ropes.
constexpr double kRopeShare = 0.02;

/// Random numbers that do not depend on the standard library's distributions.
class Random {
 public:
  float between(float lo, float hi) {
    return lo + (hi - lo) * (static_cast<float>(engine_() >> 8) * 0x1p-24f);
  }
  vec3 point(float size) {
    const float x = between(-size, size), y = between(-size, size), z = between(-size, size);
    return {x, y, z};
  }
  vec3 direction() {
    const float y = between(-1.0f, 1.0f), angle = between(0.0f, 2.0f * kPi);
    const float across = std::sqrt(std::max(0.0f, 1.0f - y * y));
    return {across * std::cos(angle), y, across * std::sin(angle)};
  }

 private:
  std::mt19937 engine_{20240229};
};

/// Adds two triangles for each of rows x columns cells of the surface at(u, v), where u and v are
/// between 0 and 1.
template <typename F>
void add_surface(mesh::TriangleMesh& mesh, int rows, int columns, const F& at) {
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  const auto stride = static_cast<std::uint32_t>(columns) + 1;
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j <= columns; ++j) {
      mesh.positions.push_back(at(static_cast<float>(i) / static_cast<float>(rows),
                                  static_cast<float>(j) / static_cast<float>(columns)));
    }
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(rows); ++i) {
    for (std::uint32_t j = 0; j + 1 < stride; ++j) {
      const std::uint32_t a = base + i * stride + j, b = a + stride;
      mesh.triangles.push_back({a, b, a + 1});
      mesh.triangles.push_back({a + 1, b, b + 1});
    }
  }
}

/// Adds a ring, or a ball if the hole has no radius. A few waves dent its surface.
void add_ring(mesh::TriangleMesh& mesh, Random& random) {
  const float size = std::exp(random.between(std::log(0.3f), std::log(6.0f)));
  const float hole = random.between(0.0f, 1.0f) < 0.5f ? 0.0f : size;
  const float dent = random.between(0.02f, 0.25f);
  const float waves_u = std::floor(random.between(2.0f, 9.0f));
  const float waves_v = std::floor(random.between(2.0f, 9.0f));
  const vec3 centre = random.point(kExtent), axis = random.direction();
  const vec3 side = glm::normalize(glm::cross(axis, random.direction()));
  const vec3 other = glm::cross(axis, side);
  const int rows = static_cast<int>(random.between(16.0f, 72.0f));
  add_surface(mesh, rows, 2 * rows, [&](float u, float v) {
    const float a = (hole > 0.0f ? 2.0f : 1.0f) * kPi * u, b = 2.0f * kPi * v;
    const float tube = size * (hole > 0.0f ? 0.4f : 1.0f) *
                       (1.0f + dent * std::sin(waves_u * a) * std::cos(waves_v * b));
    const float across = hole + tube * std::sin(a);
    return centre + axis * (tube * std::cos(a)) + side * (across * std::cos(b)) +
           other * (across * std::sin(b));
  });
}

/// Adds a straight rope of long, thin triangles.
void add_rope(mesh::TriangleMesh& mesh, Random& random) {
  const vec3 from = random.point(kExtent);
  const vec3 to = from + random.direction() * random.between(1.0f, 12.0f);
  const float radius = random.between(0.005f, 0.03f);
  const vec3 along = glm::normalize(to - from);
  const vec3 side = glm::normalize(glm::cross(along, random.direction()));
  const vec3 other = glm::cross(along, side);
  add_surface(mesh, 1, kRopeSides, [&](float u, float v) {
    const float angle = 2.0f * kPi * v;
    return from + (to - from) * u + (side * std::cos(angle) + other * std::sin(angle)) * radius;
  });
}

mesh::TriangleMesh soup_mesh(std::size_t triangles, const scene::Balloon& balloon) {
  mesh::TriangleMesh mesh;
  Random random;
  const auto ropes = static_cast<std::size_t>(kRopeShare * static_cast<double>(triangles));
  while (mesh.triangles.size() < ropes) add_rope(mesh, random);
  for (const auto& part : model::balloon(balloon)) {
    if (mesh.triangles.size() + part.mesh.triangles.size() > triangles) continue;
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), part.mesh.positions.begin(),
                          part.mesh.positions.end());
    for (const uvec3& t : part.mesh.triangles) mesh.triangles.push_back(t + base);
  }
  while (mesh.triangles.size() < triangles) add_ring(mesh, random);
  mesh.triangles.resize(triangles);
  mesh::compute_normals(mesh);
  return mesh;
}

const world::GroupKind kSoup{.name = "soup"};

/// Returns a floor of one cell, because a frame must have some ground.
world::HeightGrid floor_below() {
  const float line[] = {-2.0f * kExtent, 2.0f * kExtent};
  auto ground = std::make_shared<mesh::GridMesh>(line, line);
  for (std::uint32_t i = 0; i < 4; ++i) ground->set(i % 2, i / 2, -2.0f * kExtent, {0, 1, 0});
  return {ground};
}

}  // namespace

render::BuiltGeometry build_soup(std::size_t triangles, int width, int height) {
  scene::Scene scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  scene.image.width = width;
  scene.image.height = height;
  scene.balloon.position = {0.0, -0.5 * model::balloon_height(scene.balloon), 0.0};
  scene.balloon.height_above = scene::HeightReference::sea;
  scene.camera.position = {0.0, 10.0, 2.2 * static_cast<double>(kExtent)};
  scene.camera.target = {0.0, 0.0, 0.0};
  scene.camera.height_above = scene::HeightReference::sea;
  const Stopwatch watch;
  world::Objects objects{
      {scene::ObjectId::frame, scene::MaterialId::frame, soup_mesh(triangles, scene.balloon)}};
  world::World world{world::resolve(scene), {}};
  world.groups.push_back(world::make_group(world::kLand, floor_below()));
  world.groups.push_back(world::make_group(kSoup, std::move(objects)));
  return render::pack_world(std::move(world), nullptr, render::Meshes::keep, watch.seconds());
}

const mesh::TriangleMesh& mesh_of_soup(const render::HostGeometry& geometry) {
  return world::shape_of<world::Objects>(geometry.world, kSoup)->front().mesh;
}

}  // namespace aerostat::bench
