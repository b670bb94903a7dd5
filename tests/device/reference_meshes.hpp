#pragma once

#include <algorithm>
#include <ostream>
#include <string>

#include "closed_meshes.hpp"
#include "tracing.hpp"

/// Provides the meshes on which traversal is compared with brute force and with Embree.
namespace aerostat::test {

struct MeshCase {
  const char* name;
  Soup (*soup)();
  /// The scale of the mesh's extent and of the eyes' distances.
  float scale;
  vec3 offset;
  std::size_t fewest_hits;

  /// Returns rays from in and around the mesh towards points near it. Random rays are mixed with
  /// packets of one origin, and every eighth packet runs along an axis.
  std::vector<Ray> rays(std::size_t count, unsigned seed) const {
    std::mt19937 random(seed);
    std::vector<Ray> result;
    vec3 eye(0.0f);
    while (result.size() < count) {
      const std::size_t packet = result.size() / 16;
      if (packet % 2 == 0 || result.size() % 16 == 0) eye = random_point(random, 2.0f * scale);
      const vec3 target = random_point(random, 0.8f * scale);
      Ray ray = ray_towards(offset + eye, dvec3(offset + target));
      if (packet % 8 == 7) {
        ray.direction = vec3(0.0f);
        ray.direction[static_cast<int>(packet / 8 % 3)] = packet % 16 == 7 ? 1.0f : -1.0f;
      }
      result.push_back(ray);
    }
    return result;
  }
};

inline void PrintTo(const MeshCase& mesh, std::ostream* out) {
  *out << mesh.name;
}

/// Returns the error that single precision may make in u, v or 1-u-v of a ray that hits a triangle
/// at `t`. Vertices are known to about 6e-7 of their distance. A triangle that looks narrow from
/// the ray magnifies that.
inline double weight_tolerance(const AeroTriangle& triangle, const Ray& ray, double t) {
  const auto point = [](const aero_float* v) { return dvec3(v[0], v[1], v[2]); };
  const dvec3 a = point(triangle.v0), b = point(triangle.v1), c = point(triangle.v2);
  const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
  const double area = std::abs(glm::dot(glm::cross(b - a, c - a), dvec3(ray.direction)));
  const double reach = std::abs(t) + longest;
  return 2e-6 * reach * longest / std::max(area, 1e-300) + 1e-6;
}

inline std::vector<MeshCase> reference_meshes() {
  const vec3 here(0.0f);
  const vec3 far(17003.0f, 811.0f, -21017.0f);
  return {{"soup", [] { return random_soup(600, 51); }, 1.0f, here, 1000},
          {"sphere", [] { return sphere(24); }, 1.0f, here, 3000},
          {"terrain", [] { return terrain(16); }, 1.0f, here, 3000},
          {"slivers", [] { return slivers(600, 52); }, 1.0f, here, 0},
          {"box", [] { return subdivided_box(7); }, 1.0f, here, 3000},
          {"far_torus",
           [] {
             return placed(torus(24, 12), 500.0f, {17003.0f, 811.0f, -21017.0f});
           },
           500.0f, far, 2000}};
}

}  // namespace aerostat::test
