#pragma once

#include <cstdint>
#include <vector>

#include "../host/bvh_meshes.hpp"
#include "bvh/bvh.hpp"
#include "bvh/grid.hpp"
#include "instance.h"
#include "probe.hpp"
#include "trace_triangle.h"

/// Rays and meshes on the device, and the answers of brute force in double precision.
namespace aerostat::test {

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

struct Ray {
  vec3 origin;
  vec3 direction;  // unit
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

/// From `origin` towards `target`, the direction rounded once.
Ray ray_towards(const vec3& origin, const dvec3& target);

/// Unit vector, evenly distributed.
vec3 random_direction(std::mt19937& random);

/// Rays as the probes take them.
struct RayBuffers {
  explicit RayBuffers(const std::vector<Ray>& rays);

  std::size_t elements;
  opencl::Buffer<float> origins, directions, t_max, tuv;
  opencl::Buffer<std::uint32_t> slots;

  std::vector<Hit> hits(std::size_t count) const;
};

/// What is asked of rays: TRACE_... of packet.clh.
enum class Wanted { nearest = 0, any = 1, any_from_above = 2 };

/// A point of a model in the world.
vec3 placed(const AeroInstance& instance, const vec3& v);

/// A model somewhere within `reach` of the origin, turned and scaled at random.
AeroInstance random_instance(std::mt19937& random, float reach, std::uint32_t root);

/// A grid of no cells, for worlds without ground.
std::vector<float> no_grid();

/// A soup in the order of its tree's leaves, or a height grid, on the device.
class TracedMesh {
 public:
  explicit TracedMesh(const Soup& soup, const bvh::BuildOptions& options = {});
  explicit TracedMesh(const mesh::GridMesh& grid);
  /// Beside `own`, models that stand in the world, of which `root` is the number.
  TracedMesh(const Soup& own, const std::vector<Soup>& models, std::vector<AeroInstance> instances);

  std::vector<Hit> trace(const std::vector<Ray>& rays, int lanes,
                         Wanted wanted = Wanted::nearest) const;
  /// Several packets together, as the renderer does; a multiple of 64 rays.
  std::vector<Hit> trace_bundles(const std::vector<Ray>& rays, int lanes,
                                 Wanted wanted = Wanted::nearest) const;

  /// Of a single soup or grid.
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

/// A triangle's answer to a ray by the 3x3 determinants of a, b, c = V0-V1, d, e, f = V0-V2,
/// g, h, i = D, j, k, l = V0-O in double precision. `slack` is the least of u, v and 1-u-v: below
/// zero the ray misses.
struct ExactHit {
  double t = 0.0;
  double u = 0.0;
  double v = 0.0;
  double slack = -std::numeric_limits<double>::infinity();

  bool met(double t_max) const { return slack >= 0.0 && t >= 0.0 && t <= t_max; }
};

ExactHit exact_hit(const AeroTriangle& triangle, const Ray& ray);

/// Whether a ray enters the ground from above, by brute force: 1 yes, 0 no, -1 too near an edge, or
/// too level with the ground, to tell.
int enters(const mesh::TriangleMesh& ground, const Ray& ray);

}  // namespace aerostat::test
