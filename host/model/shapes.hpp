#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "mesh/mesh.hpp"

/// Provides building blocks of models. Each function appends closed, outward-facing triangles to a
/// mesh that has colours. Lengths are in metres.
namespace aerostat::model {

struct Vertex {
  dvec3 position{0.0};
  dvec3 normal{0.0, 1.0, 0.0};
  vec3 color{1.0f};
};

std::uint32_t add_vertex(mesh::TriangleMesh& mesh, const Vertex& vertex);

/// A grid of quads over vertex(i, j) with 0 <= i <= columns and 0 <= j <= rows. Its outside is
/// where the cross product (towards higher i) x (towards higher j) points. A wrapped direction
/// closes on itself: its last line is its first one, and `vertex` is not called for the last line.
struct Grid {
  int columns = 1;
  int rows = 1;
  bool wrap_columns = false;
  bool wrap_rows = false;
};
void add_grid(mesh::TriangleMesh& mesh, const Grid& grid,
              const std::function<Vertex(int, int)>& vertex);

/// Adds a box with sharp edges that reaches `half` to either side of `center` along x, y and z.
void add_box(mesh::TriangleMesh& mesh, const dvec3& center, const dvec3& half, const vec3& color);

/// A round tube along a path of at least two distinct points, with flat caps at both ends. `radius`
/// and `color` may vary with the index of the path's point.
struct Tube {
  std::span<const dvec3> path;
  int sides = 10;
  std::function<double(std::size_t)> radius;
  std::function<vec3(std::size_t)> color;
};
void add_tube(mesh::TriangleMesh& mesh, const Tube& tube);

/// Adds a tube with one radius and one colour along a path. `add_rod` adds a straight one.
void add_tube(mesh::TriangleMesh& mesh, std::span<const dvec3> path, double radius, int sides,
              const vec3& color);
void add_rod(mesh::TriangleMesh& mesh, const dvec3& from, const dvec3& to, double radius, int sides,
             const vec3& color);

/// Adds a level ring: a circle of `ring_radius` around `center`, thickened by `tube_radius`.
void add_torus(mesh::TriangleMesh& mesh, const dvec3& center, double ring_radius,
               double tube_radius, int segments, int sides, const vec3& color);

/// Adds the solid of a profile (x: radius, y: height above `base`) that is turned about the
/// vertical through `base`. The profile begins and ends on the axis and has the solid on its left.
/// Bends of more than 35 degrees are sharp edges. `color` is called with the index of a point.
void add_lathe(mesh::TriangleMesh& mesh, const dvec3& base, std::span<const dvec2> profile,
               int sides, const std::function<vec3(std::size_t)>& color);

void add_sphere(mesh::TriangleMesh& mesh, const dvec3& center, double radius, int sides,
                const vec3& color);

/// Returns the unit normal of a surface p(u, v) by central differences over 2 * step, on the side
/// where (dp/du) x (dp/dv) points.
dvec3 surface_normal(const std::function<dvec3(double, double)>& surface, double u, double v,
                     double step);

/// Returns a repeatable number in [0, 1) for a place in a pattern.
double hash_unit(std::uint32_t a, std::uint32_t b);

}  // namespace aerostat::model
