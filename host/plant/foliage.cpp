#include "plant/foliage.hpp"

#include <algorithm>
#include <cmath>

#include "model/shapes.hpp"

namespace aerostat::plant {
namespace {

// The share by which normals turn from those of the leaf to those of the crown. Chosen by eye.
constexpr double kBend = 0.65;

/// Returns the leaf's normal on the outer side of the crown, bent outwards. The renderer takes the
/// side that vertex normals point to for the front, so the two must agree on most leaves.
dvec3 soft_normal(const dvec3& own, const dvec3& outward) {
  const dvec3 facing = glm::dot(own, outward) < 0.0 ? -own : own;
  return glm::normalize(facing * (1.0 - kBend) + outward * kBend);
}

std::uint32_t add_shaded(mesh::TriangleMesh& mesh, const dvec3& position, const dvec3& own,
                         const vec3& color, const Crown& crown) {
  const Shade shade = crown(position);
  return model::add_vertex(
      mesh, {position, soft_normal(own, shade.outward), color * static_cast<float>(shade.light)});
}

dvec3 safe_normal(const dvec3& v) {
  const double length = glm::length(v);
  return length > 1e-12 ? v / length : dvec3(0.0, 1.0, 0.0);
}

}  // namespace

Crown ellipsoid_crown(const dvec3& center, const dvec3& radii, double dark) {
  return [=](const dvec3& position) {
    const dvec3 from = (position - center) / radii;
    const double depth = std::clamp(glm::length(from), 0.0, 1.0);
    const double below = 0.5 - 0.5 * std::clamp(from.y, -1.0, 1.0);
    const double light = (dark + (1.0 - dark) * depth * depth) * (1.0 - 0.35 * below);
    return Shade{safe_normal(from / radii), light};
  };
}

Crown open_crown() {
  return [](const dvec3&) { return Shade{}; };
}

void add_leaf(mesh::TriangleMesh& mesh, const Leaf& leaf, const Crown& crown) {
  const dvec3 along = leaf.tip - leaf.base;
  const dvec3 normal = safe_normal(glm::cross(along, leaf.across));
  const dvec3 up = normal.y < 0.0 ? -normal : normal;
  const dvec3 belly = leaf.base + along * leaf.belly;
  const dvec3 drop = up * (leaf.fold * glm::length(leaf.across));
  const vec3 tip = leaf.color * static_cast<float>(leaf.tip_gain);
  const vec3 middle = 0.5f * (leaf.color + tip);
  const std::uint32_t a = add_shaded(mesh, leaf.base, up, leaf.color, crown);
  const std::uint32_t b = add_shaded(mesh, belly + leaf.across - drop, up, middle, crown);
  const std::uint32_t c = add_shaded(mesh, leaf.tip, up, tip, crown);
  const std::uint32_t d = add_shaded(mesh, belly - leaf.across - drop, up, middle, crown);
  mesh.triangles.emplace_back(a, b, c);
  mesh.triangles.emplace_back(a, c, d);
}

void add_blade(mesh::TriangleMesh& mesh, std::span<const dvec3> path, const dvec3& across,
               const vec3& color, double tip_gain, const Crown& crown) {
  const std::size_t last = path.size() - 1;
  const auto tone = [&](std::size_t i) {
    const double t = static_cast<double>(i) / static_cast<double>(last);
    return color * static_cast<float>(1.0 + (tip_gain - 1.0) * t);
  };
  std::uint32_t left = 0, right = 0;
  for (std::size_t i = 0; i <= last; ++i) {
    const dvec3 along = i < last ? path[i + 1] - path[i] : path[i] - path[i - 1];
    const dvec3 normal = safe_normal(glm::cross(along, across));
    if (i == last) {
      const std::uint32_t tip = add_shaded(mesh, path[i], normal, tone(i), crown);
      mesh.triangles.emplace_back(left, right, tip);
      break;
    }
    const double t = static_cast<double>(i) / static_cast<double>(last);
    const dvec3 half = across * (1.0 - 0.6 * t * t);
    const std::uint32_t l = add_shaded(mesh, path[i] - half, normal, tone(i), crown);
    const std::uint32_t r = add_shaded(mesh, path[i] + half, normal, tone(i), crown);
    if (i > 0) {
      mesh.triangles.emplace_back(left, right, r);
      mesh.triangles.emplace_back(left, r, l);
    }
    left = l;
    right = r;
  }
}

void add_wood(mesh::TriangleMesh& mesh, std::span<const dvec3> path, double radius_from,
              double radius_to, int sides, const vec3& color) {
  const double last = static_cast<double>(path.size() - 1);
  const auto radius = [&](std::size_t i) {
    return radius_from + (radius_to - radius_from) * static_cast<double>(i) / last;
  };
  const auto tone = [&](std::size_t i) {
    return color * static_cast<float>(0.85 + 0.3 * model::hash_unit(static_cast<std::uint32_t>(i),
                                                                    std::uint32_t{17}));
  };
  model::add_tube(mesh, {path, sides, radius, tone});
}

void add_core(mesh::TriangleMesh& mesh, const dvec3& center, const dvec3& radii, const vec3& color,
              double yaw, const Crown& crown) {
  const double c = std::cos(yaw), s = std::sin(yaw);
  std::uint32_t corner[6];
  for (int i = 0; i < 6; ++i) {
    dvec3 direction(0.0);
    direction[i / 2] = i % 2 == 0 ? 1.0 : -1.0;
    direction = {c * direction.x + s * direction.z, direction.y, c * direction.z - s * direction.x};
    corner[i] = add_shaded(mesh, center + direction * radii, direction, color, crown);
  }
  for (int octant = 0; octant < 8; ++octant) {
    uvec3 t(corner[octant & 1], corner[2 + ((octant >> 1) & 1)], corner[4 + (octant >> 2)]);
    const int mirrored = (octant & 1) + ((octant >> 1) & 1) + (octant >> 2);
    if (mirrored % 2 == 1) std::swap(t.y, t.z);
    mesh.triangles.push_back(t);
  }
}

dvec3 level_direction(double angle) {
  return {std::cos(angle), 0.0, std::sin(angle)};
}

Across across(const dvec3& axis) {
  const dvec3 other = std::abs(axis.y) < 0.9 ? dvec3(0.0, 1.0, 0.0) : dvec3(1.0, 0.0, 0.0);
  const dvec3 right = glm::normalize(glm::cross(axis, other));
  return {right, glm::cross(right, axis)};
}

}  // namespace aerostat::plant
