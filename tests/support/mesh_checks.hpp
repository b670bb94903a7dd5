#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <unordered_map>
#include <vector>

#include "mesh/mesh.hpp"

/// Measures meshes for several tests.
namespace aerostat::test {

/// Returns a number for each vertex. Vertices at exactly the same place get the same number.
inline std::vector<std::uint32_t> welded(const mesh::TriangleMesh& mesh) {
  std::map<std::array<float, 3>, std::uint32_t> numbers;
  std::vector<std::uint32_t> result;
  for (const vec3& p : mesh.positions) {
    // Adding 0 makes -0 and 0 the same key.
    const std::array<float, 3> key{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
    result.push_back(
        numbers.try_emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second);
  }
  return result;
}

struct Edges {
  /// The number of edges that are used once. `open_vertices` contains their ends.
  std::size_t open = 0;
  /// The number of edges that are used twice in the same direction, by a flipped or a third
  /// triangle.
  std::size_t crowded = 0;
  std::vector<vec3> open_vertices;
};

/// Counts the faulty edges. In a closed surface every directed edge is used once, and so is its
/// reverse.
inline Edges count_edges(const mesh::TriangleMesh& mesh) {
  const std::vector<std::uint32_t> weld = welded(mesh);
  std::unordered_map<std::uint64_t, int> uses;
  std::unordered_map<std::uint64_t, vec3> begins;
  const auto key = [](std::uint32_t a, std::uint32_t b) {
    return (static_cast<std::uint64_t>(a) << 32) | b;
  };
  for (const uvec3& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      ++uses[key(weld[a], weld[b])];
      begins[key(weld[a], weld[b])] = mesh.positions[a];
    }
  }
  Edges edges;
  for (const auto& [edge, count] : uses) {
    if (count > 1) ++edges.crowded;
    const auto reverse =
        key(static_cast<std::uint32_t>(edge), static_cast<std::uint32_t>(edge >> 32));
    if (uses.count(reverse) > 0) continue;
    ++edges.open;
    edges.open_vertices.push_back(begins[edge]);
  }
  return edges;
}

inline double area(const mesh::TriangleMesh& mesh, const uvec3& t) {
  const dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

/// Returns the signed volume of the cones from `apex` to all triangles.
inline double volume(const mesh::TriangleMesh& mesh, const dvec3& apex = dvec3(0.0)) {
  double sum = 0.0;
  for (const uvec3& t : mesh.triangles) {
    const dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    sum += glm::dot(a - apex, glm::cross(b - apex, c - apex)) / 6.0;
  }
  return sum;
}

/// Returns the smallest cosine between a triangle's normal and the mean of its vertex normals.
inline double worst_normal(const mesh::TriangleMesh& mesh) {
  double worst = 1.0;
  for (const uvec3& t : mesh.triangles) {
    const dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const dvec3 mean(mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]);
    worst =
        std::min(worst, glm::dot(glm::normalize(glm::cross(b - a, c - a)), glm::normalize(mean)));
  }
  return worst;
}

}  // namespace aerostat::test
