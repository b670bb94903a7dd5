#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "support/bvh_meshes.hpp"

/// Builds closed meshes without a gap. Neighbours share their vertices by index, and faces wind
/// counter-clockwise as seen from outside.
namespace aerostat::test {

inline std::uint32_t middle_of(
    Soup& soup, std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>& known,
    std::uint32_t a, std::uint32_t b) {
  const auto next = static_cast<std::uint32_t>(soup.positions.size());
  const auto [place, is_new] = known.emplace(std::minmax(a, b), next);
  if (is_new) soup.positions.push_back(glm::normalize(soup.positions[a] + soup.positions[b]));
  return place->second;
}

/// Returns a unit sphere: an octahedron whose faces are divided into four, repeated `levels` times.
inline Soup icosphere(int levels) {
  Soup soup;
  soup.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  soup.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
    std::vector<uvec3> finer;
    for (const uvec3 t : soup.triangles) {
      const auto ab = middle_of(soup, known, t.x, t.y), bc = middle_of(soup, known, t.y, t.z);
      const auto ca = middle_of(soup, known, t.z, t.x);
      finer.insert(finer.end(), {{t.x, ab, ca}, {ab, t.y, bc}, {ca, bc, t.z}, {ab, bc, ca}});
    }
    soup.triangles = finer;
  }
  return soup;
}

/// Returns the cube [-1, 1]^3 with sides of cells^2 squares. Its edges run along the axes, as the
/// boxes of a tree do.
inline Soup subdivided_box(int cells) {
  Soup soup;
  std::map<std::array<int, 3>, std::uint32_t> known;
  const auto vertex = [&](std::array<int, 3> at) {
    const auto next = static_cast<std::uint32_t>(soup.positions.size());
    const auto [place, is_new] = known.emplace(at, next);
    const vec3 corner(static_cast<float>(at[0]), static_cast<float>(at[1]),
                      static_cast<float>(at[2]));
    if (is_new) soup.positions.push_back(corner * (2.0f / static_cast<float>(cells)) - 1.0f);
    return place->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int i = 0; i < 2 * cells * cells; ++i) {
      const bool far_side = i >= cells * cells;
      std::array<int, 3> at{};
      at[axis] = far_side ? cells : 0;
      at[u] = i % cells;
      at[v] = i / cells % cells;
      std::array<int, 3> along = at, across = at, both = at;
      ++along[u], ++across[v], ++both[u], ++both[v];
      if (!far_side) std::swap(along, across);
      const auto a = vertex(at), b = vertex(along), c = vertex(both), d = vertex(across);
      soup.triangles.insert(soup.triangles.end(), {{a, b, c}, {a, c, d}});
    }
  }
  return soup;
}

/// Returns a torus around y: a circle of radius 1 with `around` steps, and a tube of radius 0.4
/// with `tube` steps.
inline Soup torus(std::uint32_t around, std::uint32_t tube) {
  Soup soup;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < tube; ++j) {
      const float p = 2.0f * kPi * static_cast<float>(i) / static_cast<float>(around);
      const float q = 2.0f * kPi * static_cast<float>(j) / static_cast<float>(tube);
      const float r = 1.0f + 0.4f * std::cos(q);
      soup.positions.push_back({r * std::cos(p), 0.4f * std::sin(q), r * std::sin(p)});
      const std::uint32_t i1 = (i + 1) % around, j1 = (j + 1) % tube;
      const std::uint32_t a = i * tube + j, b = i1 * tube + j, c = i1 * tube + j1,
                          d = i * tube + j1;
      soup.triangles.insert(soup.triangles.end(), {{a, c, b}, {a, d, c}});
    }
  }
  return soup;
}

/// Returns the mesh scaled and then moved.
inline Soup placed(Soup soup, float scale, const vec3& offset) {
  for (vec3& p : soup.positions) p = p * scale + offset;
  return soup;
}

}  // namespace aerostat::test
