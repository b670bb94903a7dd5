#include "tracing.hpp"

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

RayBuffers::RayBuffers(const std::vector<Ray>& rays)
    : elements(whole_packets(rays.size())),
      origins(input(planes(vectors_of(rays, &Ray::origin)))),
      directions(input(planes(vectors_of(rays, &Ray::direction)))),
      t_max(input(reaches_of(rays))),
      tuv(output<float>(3 * elements)),
      slots(output<std::uint32_t>(elements)) {}

std::vector<Hit> RayBuffers::hits(std::size_t count) const {
  const std::vector<float> values = tuv.read();
  const std::vector<std::uint32_t> met = slots.read();
  std::vector<Hit> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    const vec3 v = from_planes(values, i);
    result[i] = {v.x, v.y, v.z, met[i]};
  }
  return result;
}

TracedMesh::TracedMesh(const Soup& soup, const bvh::BuildOptions& options)
    : tree_(bvh::build(soup.positions, soup.triangles, options)),
      triangles_(in_leaf_order(soup, tree_)),
      node_buffer_(input(tree_.nodes)),
      triangle_buffer_(input(triangles_)),
      grid_buffer_(input(no_grid())) {}

TracedMesh::TracedMesh(const mesh::GridMesh& grid)
    : tree_(bvh::build_grid(grid)),
      node_buffer_(input(tree_.nodes)),
      triangle_buffer_(input(triangles_)),
      grid_buffer_(input(std::vector<float>(grid.words().begin(), grid.words().end()))) {}

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
  probe.run(kernel, buffers.elements, node_buffer_, triangle_buffer_, grid_buffer_, buffers.origins,
            buffers.directions, buffers.t_max, static_cast<cl_int>(wanted), buffers.tuv,
            buffers.slots);
  return buffers.hits(rays.size());
}

ExactHit exact_hit(const AeroTriangle& triangle, const Ray& ray) {
  const dvec3 v0 = point(triangle.v0);
  const dvec3 abc = v0 - point(triangle.v1), def = v0 - point(triangle.v2);
  const dvec3 ghi(ray.direction), jkl = v0 - dvec3(ray.origin);
  // The system's columns are (a, b, c), (d, e, f) and (g, h, i): beta, gamma and t in this order.
  const double det = determinant(abc, def, ghi);
  ExactHit hit;
  if (det == 0.0) return hit;
  hit.u = determinant(jkl, def, ghi) / det;
  hit.v = determinant(abc, jkl, ghi) / det;
  hit.t = determinant(abc, def, jkl) / det;
  hit.slack = std::min({hit.u, hit.v, 1.0 - hit.u - hit.v});
  return hit;
}

}  // namespace aerostat::test
