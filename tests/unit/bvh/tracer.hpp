#pragma once

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "bvh/bvh.hpp"
#include "support/bvh_meshes.hpp"

/// Traces rays in double precision, with a tree and without one.
namespace aerostat::test {

inline constexpr double kMiss = std::numeric_limits<double>::infinity();
struct Ray {
  dvec3 origin, direction;
};

// Returns the distance to a triangle by the method of Moeller and Trumbore in double precision, or
// kMiss.
inline double hit_triangle(const Soup& soup, std::uint32_t triangle, const Ray& ray) {
  const uvec3 t = soup.triangles[triangle];
  const dvec3 v0(soup.positions[t.x]);
  const dvec3 e1 = dvec3(soup.positions[t.y]) - v0, e2 = dvec3(soup.positions[t.z]) - v0;
  const dvec3 p = glm::cross(ray.direction, e2);
  const double determinant = glm::dot(e1, p);
  if (determinant == 0.0) return kMiss;
  const dvec3 s = ray.origin - v0, q = glm::cross(s, e1);
  const double u = glm::dot(s, p) / determinant;
  const double v = glm::dot(ray.direction, q) / determinant;
  const double distance = glm::dot(e2, q) / determinant;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0 ? distance : kMiss;
}

// Returns the distance to a child's box, or kMiss. The test is slightly too generous rather than
// too strict.
inline double hit_box(const AeroBvhNode& node, int i, const Ray& ray, double nearest) {
  double enter = 0.0, leave = nearest;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1.0 / ray.direction[axis];
    const double a = (static_cast<double>(node.lo[axis][i]) - ray.origin[axis]) * inverse;
    const double b = (static_cast<double>(node.hi[axis][i]) - ray.origin[axis]) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave * (1.0 + 1e-12) + 1e-12 ? enter : kMiss;
}

// Traces rays by the plainest traversal, which puts every child that is hit onto the stack.
class Tracer {
 public:
  Tracer(const bvh::Bvh& tree, const Soup& soup) : tree_(tree), soup_(soup) {}

  double closest(const Ray& ray) {
    double nearest = kMiss;
    std::vector<std::uint32_t> stack{0};
    while (!stack.empty()) {
      deepest = std::max(deepest, stack.size());
      const std::uint32_t reference = stack.back();
      stack.pop_back();
      if ((reference & AERO_BVH_LEAF) != 0) {
        nearest = std::min(nearest, closest_in_leaf(reference, ray));
        continue;
      }
      const AeroBvhNode& node = tree_.nodes[reference];
      for (int i = 0; i < AERO_BVH_WIDTH; ++i) {
        if (node.child[i] != AERO_BVH_EMPTY && hit_box(node, i, ray, nearest) < kMiss)
          stack.push_back(node.child[i]);
      }
    }
    return nearest;
  }

  std::size_t deepest = 0;
  std::size_t triangles_tested = 0;

 private:
  double closest_in_leaf(std::uint32_t reference, const Ray& ray) {
    const std::uint32_t first = reference & AERO_BVH_FIRST_MASK;
    const std::uint32_t count = ((reference >> AERO_BVH_COUNT_SHIFT) & AERO_BVH_COUNT_MASK) + 1;
    double nearest = kMiss;
    for (std::uint32_t slot = first; slot < first + count; ++slot)
      nearest = std::min(nearest, hit_triangle(soup_, tree_.order[slot], ray));
    triangles_tested += count;
    return nearest;
  }

  const bvh::Bvh& tree_;
  const Soup& soup_;
};

// Returns a ray from a random point in [-2, 2]^3 towards a random point near the mesh.
inline Ray random_ray(std::mt19937& random) {
  const vec3 origin = random_point(random, 2.0f);
  const vec3 target = random_point(random, 0.8f);
  return {dvec3(origin), glm::normalize(dvec3(target) - dvec3(origin))};
}

}  // namespace aerostat::test
