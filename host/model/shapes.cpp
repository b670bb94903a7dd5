#include "model/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace aerostat::model {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
/// The cosine of the bend of a profile from which its edge is sharp. It is that of 35 degrees.
constexpr double kSharpBendCosine = 0.82;

using mesh::TriangleMesh;

dvec3 any_perpendicular(const dvec3& axis) {
  const dvec3 other = std::abs(axis.y) < 0.9 ? dvec3(0.0, 1.0, 0.0) : dvec3(1.0, 0.0, 0.0);
  return glm::normalize(glm::cross(axis, other));
}

/// The tangent and one axis of the cross-section at a point of a path. The axis is carried along
/// the path with the least twist.
struct Frame {
  dvec3 tangent, side;
};

std::vector<Frame> path_frames(std::span<const dvec3> path) {
  std::vector<Frame> frames(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const dvec3& before = path[i == 0 ? 0 : i - 1];
    const dvec3& after = path[std::min(i + 1, path.size() - 1)];
    const dvec3 tangent = glm::normalize(after - before);
    dvec3 side = i == 0 ? any_perpendicular(tangent) : frames[i - 1].side;
    side = glm::normalize(side - tangent * glm::dot(side, tangent));
    frames[i] = {tangent, side};
  }
  return frames;
}

enum class End { first, last };

void add_cap(TriangleMesh& mesh, End end, const dvec3& center, const Frame& frame, double radius,
             int sides, const vec3& color) {
  const dvec3 normal = end == End::last ? frame.tangent : -frame.tangent;
  const dvec3 other = glm::cross(frame.tangent, frame.side);
  const std::uint32_t hub = add_vertex(mesh, {center, normal, color});
  for (int i = 0; i < sides; ++i) {
    const double angle = kTwoPi * i / sides;
    const dvec3 out = frame.side * std::cos(angle) + other * std::sin(angle);
    add_vertex(mesh, {center + radius * out, normal, color});
  }
  for (int i = 0; i < sides; ++i) {
    uvec3 triangle(hub, hub + 1 + i, hub + 1 + (i + 1) % sides);
    if (end == End::first) std::swap(triangle.y, triangle.z);
    mesh.triangles.push_back(triangle);
  }
}

/// Returns the normal of a profile segment that has the solid on its left.
dvec2 segment_normal(const dvec2& a, const dvec2& b) {
  const dvec2 d = glm::normalize(b - a);
  return {d.y, -d.x};
}

/// Returns the normal at an end of a segment. It is averaged with the normal of the neighbouring
/// segment unless the profile bends sharply there.
dvec2 joined_normal(const dvec2& own, const dvec2& neighbour) {
  return glm::dot(own, neighbour) < kSharpBendCosine ? own : glm::normalize(own + neighbour);
}

void add_lathe_band(TriangleMesh& mesh, const dvec3& base, const Vertex (&ends)[2], int sides) {
  const auto turned = [&](int side, const Vertex& v) {
    const double angle = kTwoPi * side / sides;
    const double c = std::cos(angle), s = -std::sin(angle);
    return Vertex{base + dvec3(v.position.x * c, v.position.y, v.position.x * s),
                  dvec3(v.normal.x * c, v.normal.y, v.normal.x * s), v.color};
  };
  const std::uint32_t first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i < sides; ++i) {
    for (const Vertex& end : ends) add_vertex(mesh, turned(i, end));
  }
  for (int i = 0; i < sides; ++i) {
    const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % sides);
    if (ends[0].position.x > 0.0)
      mesh.triangles.emplace_back(a, b, ends[1].position.x > 0.0 ? b + 1 : a + 1);
    if (ends[1].position.x > 0.0) mesh.triangles.emplace_back(a, b + 1, a + 1);
  }
}

}  // namespace

std::uint32_t add_vertex(TriangleMesh& mesh, const Vertex& vertex) {
  mesh.positions.emplace_back(vertex.position);
  mesh.normals.push_back(glm::normalize(vec3(vertex.normal)));
  mesh.colors.push_back(vertex.color);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void add_grid(TriangleMesh& mesh, const Grid& grid, const std::function<Vertex(int, int)>& vertex) {
  const int lines_i = grid.wrap_columns ? grid.columns : grid.columns + 1;
  const int lines_j = grid.wrap_rows ? grid.rows : grid.rows + 1;
  const std::uint32_t first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int j = 0; j < lines_j; ++j) {
    for (int i = 0; i < lines_i; ++i) add_vertex(mesh, vertex(i, j));
  }
  const auto index = [&](int i, int j) {
    return first + static_cast<std::uint32_t>((j % lines_j) * lines_i + i % lines_i);
  };
  for (int j = 0; j < grid.rows; ++j) {
    for (int i = 0; i < grid.columns; ++i) {
      mesh.triangles.emplace_back(index(i, j), index(i + 1, j), index(i + 1, j + 1));
      mesh.triangles.emplace_back(index(i, j), index(i + 1, j + 1), index(i, j + 1));
    }
  }
}

void add_box(TriangleMesh& mesh, const dvec3& center, const dvec3& half, const vec3& color) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      dvec3 normal(0.0), u(0.0), v(0.0);
      normal[axis] = sign;
      u[(axis + 1) % 3] = half[(axis + 1) % 3];
      v[(axis + 2) % 3] = sign * half[(axis + 2) % 3];
      const dvec3 middle = center + normal * half[axis];
      add_grid(mesh, {}, [&](int i, int j) {
        return Vertex{middle + u * (2.0 * i - 1.0) + v * (2.0 * j - 1.0), normal, color};
      });
    }
  }
}

void add_tube(TriangleMesh& mesh, const Tube& tube) {
  const std::vector<Frame> frames = path_frames(tube.path);
  const std::size_t last = tube.path.size() - 1;
  const Grid grid{tube.sides, static_cast<int>(last), true, false};
  add_grid(mesh, grid, [&](int i, int j) {
    const Frame& frame = frames[static_cast<std::size_t>(j)];
    const double angle = kTwoPi * i / tube.sides;
    const dvec3 out =
        frame.side * std::cos(angle) + glm::cross(frame.tangent, frame.side) * std::sin(angle);
    const auto k = static_cast<std::size_t>(j);
    return Vertex{tube.path[k] + tube.radius(k) * out, out, tube.color(k)};
  });
  add_cap(mesh, End::first, tube.path[0], frames[0], tube.radius(0), tube.sides, tube.color(0));
  add_cap(mesh, End::last, tube.path[last], frames[last], tube.radius(last), tube.sides,
          tube.color(last));
}

void add_tube(TriangleMesh& mesh, std::span<const dvec3> path, double radius, int sides,
              const vec3& color) {
  add_tube(mesh, {path, sides, [radius](std::size_t) { return radius; },
                  [&color](std::size_t) { return color; }});
}

void add_rod(TriangleMesh& mesh, const dvec3& from, const dvec3& to, double radius, int sides,
             const vec3& color) {
  const dvec3 path[2] = {from, to};
  add_tube(mesh, path, radius, sides, color);
}

void add_torus(TriangleMesh& mesh, const dvec3& center, double ring_radius, double tube_radius,
               int segments, int sides, const vec3& color) {
  add_grid(mesh, {segments, sides, true, true}, [&](int i, int j) {
    const double around = kTwoPi * i / segments, across = kTwoPi * j / sides;
    const dvec3 out(std::cos(around), 0.0, -std::sin(around));
    const dvec3 normal = out * std::cos(across) + dvec3(0.0, std::sin(across), 0.0);
    return Vertex{center + out * ring_radius + normal * tube_radius, normal, color};
  });
}

void add_lathe(TriangleMesh& mesh, const dvec3& base, std::span<const dvec2> profile, int sides,
               const std::function<vec3(std::size_t)>& color) {
  const std::size_t segments = profile.size() - 1;
  std::vector<dvec2> normals(segments);
  for (std::size_t k = 0; k < segments; ++k)
    normals[k] = segment_normal(profile[k], profile[k + 1]);
  for (std::size_t k = 0; k < segments; ++k) {
    const dvec2 own = normals[k];
    dvec2 lower = k == 0 ? own : joined_normal(own, normals[k - 1]);
    dvec2 upper = k + 1 == segments ? own : joined_normal(own, normals[k + 1]);
    if (profile[k].x == 0.0 && own.y < -kSharpBendCosine) lower = {0.0, -1.0};
    if (profile[k + 1].x == 0.0 && own.y > kSharpBendCosine) upper = {0.0, 1.0};
    const Vertex ends[2] = {{dvec3(profile[k], 0.0), dvec3(lower, 0.0), color(k)},
                            {dvec3(profile[k + 1], 0.0), dvec3(upper, 0.0), color(k + 1)}};
    add_lathe_band(mesh, base, ends, sides);
  }
}

void add_sphere(TriangleMesh& mesh, const dvec3& center, double radius, int sides,
                const vec3& color) {
  const int rings = std::max(sides / 2, 4);
  std::vector<dvec2> profile;
  for (int i = 0; i <= rings; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) / rings - 0.5);
    const bool pole = i == 0 || i == rings;
    profile.emplace_back(pole ? 0.0 : radius * std::cos(angle), radius * std::sin(angle));
  }
  add_lathe(mesh, center, profile, sides, [&color](std::size_t) { return color; });
}

dvec3 surface_normal(const std::function<dvec3(double, double)>& surface, double u, double v,
                     double step) {
  const dvec3 along_u = surface(u + step, v) - surface(u - step, v);
  const dvec3 along_v = surface(u, v + step) - surface(u, v - step);
  return glm::normalize(glm::cross(along_u, along_v));
}

double hash_unit(std::uint32_t a, std::uint32_t b) {
  std::uint32_t x = a * 0x9e3779b9u + b * 0x85ebca6bu + 0x27d4eb2fu;
  x = (x ^ (x >> 15)) * 0x2c1b3c6du;
  x = (x ^ (x >> 12)) * 0x297a2d39u;
  return static_cast<double>(x ^ (x >> 15)) * 0x1p-32;
}

}  // namespace aerostat::model
