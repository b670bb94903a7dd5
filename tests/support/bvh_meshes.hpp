#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "core/math.hpp"

/// Builds small, reproducible meshes for the tests of the BVH.
namespace aerostat::test {

struct Soup {
  std::vector<vec3> positions;
  std::vector<uvec3> triangles;

  void add(const vec3& a, const vec3& b, const vec3& c) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), {a, b, c});
    triangles.push_back({first, first + 1, first + 2});
  }
};

inline vec3 random_point(std::mt19937& random, float radius) {
  std::uniform_real_distribution<float> coordinate(-radius, radius);
  const float x = coordinate(random), y = coordinate(random), z = coordinate(random);
  return {x, y, z};
}

/// Returns the coordinates of a grid's lines over [-1, 1], which are farther apart towards the
/// border.
inline std::vector<float> grid_lines(std::uint32_t cells) {
  std::vector<float> values;
  for (std::uint32_t i = 0; i <= cells; ++i) {
    const float t = 2.0f * static_cast<float>(i) / static_cast<float>(cells) - 1.0f;
    values.push_back(t * (0.3f + 0.7f * t * t));
  }
  return values;
}

/// Returns triangles of mixed sizes in [-1, 1]^3.
inline Soup random_soup(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  Soup soup;
  for (std::size_t i = 0; i < count; ++i) {
    const float size = i % 50 == 0 ? 0.5f : 0.05f;
    const vec3 centre = random_point(random, 1.0f);
    const vec3 a = random_point(random, size), b = random_point(random, size);
    soup.add(centre, centre + a, centre + b);
  }
  return soup;
}

/// Returns a bumpy terrain over [-1, 1]^2 in x and z, with cells^2 cells of two triangles each.
inline Soup terrain(std::uint32_t cells) {
  Soup soup;
  for (std::uint32_t j = 0; j <= cells; ++j) {
    for (std::uint32_t i = 0; i <= cells; ++i) {
      const float x = 2.0f * static_cast<float>(i) / static_cast<float>(cells) - 1.0f;
      const float z = 2.0f * static_cast<float>(j) / static_cast<float>(cells) - 1.0f;
      const float y =
          0.3f * std::sin(5.0f * x) * std::cos(4.0f * z) + 0.05f * std::sin(31.0f * x * z);
      soup.positions.push_back({x, y, z});
    }
  }
  const std::uint32_t row = cells + 1;
  for (std::uint32_t j = 0; j < cells; ++j) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t a = j * row + i;
      soup.triangles.push_back({a, a + row, a + 1});
      soup.triangles.push_back({a + 1, a + row, a + row + 1});
    }
  }
  return soup;
}

/// Returns a unit sphere of `slices` by slices / 2 quads. The quads at the poles have a side of
/// length zero.
inline Soup sphere(std::uint32_t slices) {
  Soup soup;
  const std::uint32_t stacks = slices / 2;
  const auto point = [&](std::uint32_t i, std::uint32_t j) {
    const float elevation = kPi * (static_cast<float>(j) / static_cast<float>(stacks) - 0.5f);
    const float azimuth = 2.0f * kPi * static_cast<float>(i % slices) / static_cast<float>(slices);
    if (j == 0 || j == stacks) return vec3(0.0f, j == 0 ? -1.0f : 1.0f, 0.0f);
    return direction_from_angles(azimuth, elevation);
  };
  for (std::uint32_t j = 0; j < stacks; ++j) {
    for (std::uint32_t i = 0; i < slices; ++i) {
      soup.add(point(i, j), point(i + 1, j), point(i, j + 1));
      soup.add(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
    }
  }
  return soup;
}

/// Returns needles across [-1, 1]^3 that are 10^4 times as long as wide.
inline Soup slivers(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  Soup soup;
  for (std::size_t i = 0; i < count; ++i) {
    const vec3 a = random_point(random, 1.0f), b = random_point(random, 1.0f);
    soup.add(a, b, b + random_point(random, 1e-4f));
  }
  return soup;
}

/// Returns triangles with one corner at the origin whose sizes grow geometrically from 10^-e to
/// 10^e.
inline Soup geometric(std::size_t count, double exponent) {
  Soup soup;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count - 1);
    const auto size = static_cast<float>(std::pow(10.0, exponent * (2.0 * t - 1.0)));
    soup.add({0.0f, 0.0f, 0.0f}, {size, 0.0f, size}, {size, size, 0.0f});
  }
  return soup;
}

/// Returns clusters of seven triangles. Each cluster is beside the one before and 16 times its
/// size. The cheapest wide nodes spend their slots on the large triangles and descend one cluster
/// at a time.
inline Soup nested_clusters(int clusters) {
  Soup soup;
  for (int k = 0; k < clusters; ++k) {
    const float size = std::ldexp(1.0f, 4 * k - 2 * clusters);
    for (int i = 1; i <= 7; ++i) {
      const float x = size * (0.3f + 0.1f * static_cast<float>(i));
      soup.add({x, 0.0f, 0.0f}, {x, size, 0.1f * size}, {x, 0.1f * size, size});
    }
  }
  return soup;
}

}  // namespace aerostat::test
