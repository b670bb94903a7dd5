#include "mesh/mesh.hpp"

#include <cstdint>

#include <fmt/format.h>

#include "core/error.hpp"

namespace aerostat::mesh {

void append(TriangleMesh& whole, const TriangleMesh& part) {
  const std::size_t first = whole.positions.size();
  const vec3 white(1.0f);
  if (!part.colors.empty() && whole.colors.empty()) whole.colors.assign(first, white);
  whole.positions.insert(whole.positions.end(), part.positions.begin(), part.positions.end());
  whole.normals.insert(whole.normals.end(), part.normals.begin(), part.normals.end());
  if (!part.colors.empty()) {
    whole.colors.insert(whole.colors.end(), part.colors.begin(), part.colors.end());
  } else if (!whole.colors.empty()) {
    whole.colors.resize(whole.positions.size(), white);
  }
  if (!part.uvs.empty() || !whole.uvs.empty()) {
    whole.uvs.resize(first, vec2(0.0f));
    whole.uvs.insert(whole.uvs.end(), part.uvs.begin(), part.uvs.end());
    whole.uvs.resize(whole.positions.size(), vec2(0.0f));
  }
  const uvec3 offset(static_cast<std::uint32_t>(first));
  const std::size_t before = whole.triangles.size();
  whole.triangles.insert(whole.triangles.end(), part.triangles.begin(), part.triangles.end());
  for (std::size_t i = before; i < whole.triangles.size(); ++i) whole.triangles[i] += offset;
}

void compute_normals(TriangleMesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), vec3(0.0f));
  for (const uvec3& t : mesh.triangles) {
    const vec3& a = mesh.positions[t.x];
    const vec3 twice_area = glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
    for (int corner = 0; corner < 3; ++corner) mesh.normals[t[corner]] += twice_area;
  }
  for (vec3& normal : mesh.normals) {
    const float length = glm::length(normal);
    normal = length > 0.0f ? normal / length : vec3(0.0f, 1.0f, 0.0f);
  }
}

namespace {

[[noreturn]] void fail(const char* name, const std::string& what) {
  throw Error(ErrorKind::internal, fmt::format("mesh '{}': {}", name, what));
}

}  // namespace

void check(const TriangleMesh& mesh, const char* name) {
  const std::size_t count = mesh.positions.size();
  if (mesh.normals.size() != count) {
    fail(name, fmt::format("{} normals for {} positions", mesh.normals.size(), count));
  }
  if (!mesh.colors.empty() && mesh.colors.size() != count) {
    fail(name, fmt::format("{} colours for {} positions", mesh.colors.size(), count));
  }
  if (!mesh.uvs.empty() && mesh.uvs.size() != count) {
    fail(name, fmt::format("{} uvs for {} positions", mesh.uvs.size(), count));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const uvec3& t = mesh.triangles[i];
    if (t.x >= count || t.y >= count || t.z >= count) {
      fail(name, fmt::format("triangle {} has the indices {}, {}, {}, but there are {} positions",
                             i, t.x, t.y, t.z, count));
    }
  }
}

}  // namespace aerostat::mesh
