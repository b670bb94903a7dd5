#pragma once

#include <cstdint>
#include <vector>

#include "bvh/bvh.hpp"
#include "bvh/grid.hpp"
#include "instance.h"
#include "probe.hpp"
#include "support/bvh_meshes.hpp"
#include "trace_triangle.h"

/// Traces rays on the device, and computes the answers by brute force in double precision.
namespace aerostat::test {

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

struct Ray {
  vec3 origin;
  /// The direction as a unit vector.
  vec3 direction;
  float t_max = kInfinity;
};

struct Hit {
  float t = kInfinity;
  float u = 0.0f;
  float v = 0.0f;
  std::uint32_t slot = kNoTriangle;
  std::uint32_t instance = kNoTriangle;

  bool met() const { return slot != kNoTriangle; }
};

/// Returns a ray from `origin` towards `target`. The direction is rounded only once.
Ray ray_towards(const vec3& origin, const dvec3& target);

/// Returns an evenly distributed random unit vector.
vec3 random_direction(std::mt19937& random);

/// The buffers of rays as the probes take them.
struct RayBuffers {
  explicit RayBuffers(const std::vector<Ray>& rays);

  std::size_t elements;
  opencl::Buffer<float> origins, directions, t_max, tuv;
  opencl::Buffer<std::uint32_t> slots;

  std::vector<Hit> hits(std::size_t count) const;
};

/// The kind of hit that is searched: the values of TRACE_... in packet.clh.
enum class Wanted { nearest = 0, any = 1, any_from_above = 2 };

/// Returns the place in the world of a point of a model.
vec3 placed(const AeroInstance& instance, const vec3& v);

/// Returns a randomly turned and scaled model within `reach` of the origin.
AeroInstance random_instance(std::mt19937& random, float reach, std::uint32_t root);

/// Returns a grid without cells, for worlds without ground.
std::vector<float> no_grid();

/// A soup in the order of its tree's leaves, or a height grid, on the device.
class TracedMesh {
 public:
  explicit TracedMesh(const Soup& soup, const bvh::BuildOptions& options = {});
  explicit TracedMesh(const mesh::GridMesh& grid);
  /// Makes a world of the soup `own` and instances of models. The `root` of an instance is the
  /// number of its model.
  TracedMesh(const Soup& own, const std::vector<Soup>& models, std::vector<AeroInstance> instances);

  std::vector<Hit> trace(const std::vector<Ray>& rays, int lanes,
                         Wanted wanted = Wanted::nearest) const;
  /// Traces several packets together, as the renderer does. The number of rays must be a multiple
  /// of 64.
  std::vector<Hit> trace_bundles(const std::vector<Ray>& rays, int lanes,
                                 Wanted wanted = Wanted::nearest) const;

  /// Returns the tree of a single soup or grid.
  const bvh::Bvh& tree() const { return tree_; }
  const std::vector<AeroTriangle>& triangles() const { return triangles_; }

 private:
  std::vector<Hit> run(const char* kernel, const std::vector<Ray>& rays, int lanes,
                       Wanted wanted) const;

  bvh::Bvh tree_;
  std::vector<AeroTriangle> triangles_;
  opencl::Buffer<AeroBvhNode> node_buffer_;
  opencl::Buffer<AeroTriangle> triangle_buffer_;
  opencl::Buffer<AeroInstance> instance_buffer_;
  opencl::Buffer<float> grid_buffer_;
};

/// The hit of a ray on a triangle, computed in double precision by the 3x3 determinants of
///   a, b, c = V0-V1,  d, e, f = V0-V2,  g, h, i = D,  j, k, l = V0-O.
/// `slack` is the least of u, v and 1-u-v. If it is below zero, the ray misses.
struct ExactHit {
  double t = 0.0;
  double u = 0.0;
  double v = 0.0;
  double slack = -std::numeric_limits<double>::infinity();

  bool met(double t_max) const { return slack >= 0.0 && t >= 0.0 && t <= t_max; }
};

ExactHit exact_hit(const AeroTriangle& triangle, const Ray& ray);

/// Returns whether a ray enters the ground from above, by brute force: 1 for yes and 0 for no. The
/// result is -1 if the ray is too near an edge or too level with the ground to tell.
int enters(const mesh::TriangleMesh& ground, const Ray& ray);

}  // namespace aerostat::test
