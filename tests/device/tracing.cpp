#include "tracing.hpp"

#include <algorithm>

#include "bvh/instances.hpp"
#include "height_grid.h"

namespace aerostat::test {
namespace {

template <typename Member>
std::vector<vec3> vectors_of(const std::vector<Ray>& rays, Member member) {
  std::vector<vec3> vectors;
  vectors.reserve(rays.size());
  for (const Ray& ray : rays) vectors.push_back(ray.*member);
  return vectors;
}

std::vector<float> reaches_of(const std::vector<Ray>& rays) {
  std::vector<float> values;
  values.reserve(rays.size());
  for (const Ray& ray : rays) values.push_back(ray.t_max);
  return padded(values);
}

void copy(const vec3& from, aero_float* to) {
  for (int axis = 0; axis < 3; ++axis) to[axis] = from[axis];
}

std::vector<AeroTriangle> in_leaf_order(const Soup& soup, const bvh::Bvh& tree) {
  std::vector<AeroTriangle> triangles(tree.order.size());
  for (std::size_t slot = 0; slot < triangles.size(); ++slot) {
    const uvec3 corners = soup.triangles[tree.order[slot]];
    copy(soup.positions[corners.x], triangles[slot].v0);
    copy(soup.positions[corners.y], triangles[slot].v1);
    copy(soup.positions[corners.z], triangles[slot].v2);
  }
  return triangles;
}

bvh::Bounds placed_bounds(const Soup& model, const AeroInstance& instance) {
  bvh::Bounds bounds;
  for (const vec3& v : model.positions) {
    const vec3 p = placed(instance, v);
    bounds.lo = glm::min(bounds.lo, p - 1e-4f);
    bounds.hi = glm::max(bounds.hi, p + 1e-4f);
  }
  return bounds;
}

dvec3 point(const aero_float* v) {
  return {v[0], v[1], v[2]};
}

double determinant(const dvec3& x, const dvec3& y, const dvec3& z) {
  return x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) +
         x[2] * (y[0] * z[1] - y[1] * z[0]);
}

}  // namespace

Ray ray_towards(const vec3& origin, const dvec3& target) {
  return {origin, vec3(glm::normalize(target - dvec3(origin)))};
}

vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<float> normal;
  vec3 v(0.0f);
  while (glm::dot(v, v) < 1e-4f) {
    const float x = normal(random), y = normal(random), z = normal(random);
    v = {x, y, z};
  }
  return glm::normalize(v);
}

std::vector<float> no_grid() {
  return std::vector<float>(AERO_GRID_HEADER + 2, 0.0f);
}

AeroInstance random_instance(std::mt19937& random, float reach, std::uint32_t root) {
  const vec3 y = random_direction(random);
  const vec3 x = glm::normalize(glm::cross(y, random_direction(random)));
  AeroInstance instance{};
  instance.scale = std::uniform_real_distribution<float>(0.3f, 2.0f)(random);
  copy(x * instance.scale, instance.axes[0]);
  copy(y * instance.scale, instance.axes[1]);
  copy(glm::cross(x, y) * instance.scale, instance.axes[2]);
  copy(random_point(random, reach), instance.position);
  copy(glm::abs(random_point(random, 1.0f)), instance.tint);
  instance.root = root;
  return instance;
}

vec3 placed(const AeroInstance& instance, const vec3& v) {
  vec3 p;
  for (int c = 0; c < 3; ++c) {
    p[c] = instance.position[c] + instance.axes[0][c] * v.x + instance.axes[1][c] * v.y +
           instance.axes[2][c] * v.z;
  }
  return p;
}

RayBuffers::RayBuffers(const std::vector<Ray>& rays)
    : elements(whole_packets(rays.size())),
      origins(input(planes(vectors_of(rays, &Ray::origin)))),
      directions(input(planes(vectors_of(rays, &Ray::direction)))),
      t_max(input(reaches_of(rays))),
      tuv(output<float>(3 * elements)),
      slots(output<std::uint32_t>(2 * elements)) {}

std::vector<Hit> RayBuffers::hits(std::size_t count) const {
  const std::vector<float> values = tuv.read();
  const std::vector<std::uint32_t> met = slots.read();
  std::vector<Hit> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    const vec3 v = from_planes(values, i);
    result[i] = {v.x, v.y, v.z, met[i], met[met.size() / 2 + i]};
  }
  return result;
}

TracedMesh::TracedMesh(const Soup& soup, const bvh::BuildOptions& options)
    : tree_(bvh::build(soup.positions, soup.triangles, options)),
      triangles_(in_leaf_order(soup, tree_)),
      node_buffer_(input(tree_.nodes)),
      triangle_buffer_(input(triangles_)),
      instance_buffer_(input(std::vector<AeroInstance>())),
      grid_buffer_(input(no_grid())) {}

TracedMesh::TracedMesh(const mesh::GridMesh& grid)
    : tree_(bvh::build_grid(grid)),
      node_buffer_(input(tree_.nodes)),
      triangle_buffer_(input(triangles_)),
      instance_buffer_(input(std::vector<AeroInstance>())),
      grid_buffer_(input(std::vector<float>(grid.words().begin(), grid.words().end()))) {}

TracedMesh::TracedMesh(const Soup& own, const std::vector<Soup>& models,
                       std::vector<AeroInstance> instances) {
  std::vector<bvh::Bvh> trees;
  const bvh::Bvh own_tree = bvh::build(own.positions, own.triangles);
  triangles_ = in_leaf_order(own, own_tree);
  for (const Soup& model : models) {
    trees.push_back(bvh::build(model.positions, model.triangles));
    const auto more = in_leaf_order(model, trees.back());
    triangles_.insert(triangles_.end(), more.begin(), more.end());
  }
  std::vector<bvh::Bounds> bounds;
  for (AeroInstance& instance : instances) {
    bounds.push_back(placed_bounds(models[instance.root], instance));
    copy(bounds.back().lo, instance.lo);
    copy(bounds.back().hi, instance.hi);
  }
  const bvh::Bvh over = bvh::build_instances(bounds);
  std::vector<bvh::Part> parts{{&own_tree}, {&over}};
  for (const bvh::Bvh& tree : trees) parts.push_back({&tree, true});
  const bvh::JoinedBvh joined = bvh::join(parts);
  for (AeroInstance& instance : instances) instance.root = joined.model_roots[instance.root];
  tree_ = joined;
  node_buffer_ = input(tree_.nodes);
  triangle_buffer_ = input(triangles_);
  instance_buffer_ = input(instances);
  grid_buffer_ = input(no_grid());
}

std::vector<Hit> TracedMesh::trace(const std::vector<Ray>& rays, int lanes, Wanted wanted) const {
  return run("probe_trace", rays, lanes, wanted);
}

std::vector<Hit> TracedMesh::trace_bundles(const std::vector<Ray>& rays, int lanes,
                                           Wanted wanted) const {
  EXPECT_EQ(rays.size() % 64, 0u);
  return run("probe_bundle", rays, lanes, wanted);
}

std::vector<Hit> TracedMesh::run(const char* kernel, const std::vector<Ray>& rays, int lanes,
                                 Wanted wanted) const {
  const Probe probe("trace.cl", lanes);
  const RayBuffers buffers(rays);
  probe.run(kernel, buffers.elements, node_buffer_, triangle_buffer_, instance_buffer_,
            grid_buffer_, buffers.origins, buffers.directions, buffers.t_max,
            static_cast<std::int32_t>(wanted), buffers.tuv, buffers.slots);
  return buffers.hits(rays.size());
}

ExactHit exact_hit(const AeroTriangle& triangle, const Ray& ray) {
  const dvec3 v0 = point(triangle.v0);
  const dvec3 abc = v0 - point(triangle.v1), def = v0 - point(triangle.v2);
  const dvec3 ghi(ray.direction), jkl = v0 - dvec3(ray.origin);
  // The columns of the system are (a, b, c), (d, e, f) and (g, h, i). They belong to beta, gamma
  // and t.
  const double det = determinant(abc, def, ghi);
  ExactHit hit;
  if (det == 0.0) return hit;
  hit.u = determinant(jkl, def, ghi) / det;
  hit.v = determinant(abc, jkl, ghi) / det;
  hit.t = determinant(abc, def, jkl) / det;
  hit.slack = std::min({hit.u, hit.v, 1.0 - hit.u - hit.v});
  return hit;
}

int enters(const mesh::TriangleMesh& ground, const Ray& ray) {
  int answer = 0;
  for (const uvec3& t : ground.triangles) {
    AeroTriangle triangle;
    for (int axis = 0; axis < 3; ++axis) {
      triangle.v0[axis] = ground.positions[t.x][axis];
      triangle.v1[axis] = ground.positions[t.y][axis];
      triangle.v2[axis] = ground.positions[t.z][axis];
    }
    const ExactHit hit = exact_hit(triangle, ray);
    if (hit.slack < -1e-4 || hit.t < -1e-4 || hit.t > ray.t_max * 1.0001) continue;
    const dvec3 a(ground.positions[t.x]);
    const dvec3 n = glm::normalize(
        glm::cross(dvec3(ground.positions[t.y]) - a, dvec3(ground.positions[t.z]) - a));
    const double facing = -glm::dot(n, dvec3(ray.direction));
    if (facing < -1e-4) continue;
    const bool sure = hit.slack > 1e-4 && hit.t > 1e-4 && hit.t < ray.t_max * 0.9999;
    if (sure && facing > 1e-4) return 1;
    answer = -1;
  }
  return answer;
}

}  // namespace aerostat::test
