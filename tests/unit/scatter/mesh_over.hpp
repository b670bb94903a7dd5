#pragma once

#include <vector>

#include "mesh/grid_mesh.hpp"

namespace aerostat::scatter {

/// Returns a square grid of cells x cells whose height is a function of the place.
template <class Height>
mesh::GridMesh mesh_over(int cells, double size_m, Height height) {
  std::vector<float> lines;
  for (int i = 0; i <= cells; ++i)
    lines.push_back(static_cast<float>(size_m * (static_cast<double>(i) / cells - 0.5)));
  mesh::GridMesh mesh(lines, lines);
  const double step = size_m / cells;
  for (std::uint32_t j = 0; j < lines.size(); ++j) {
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
      const double x = static_cast<double>(lines[i]), z = static_cast<double>(lines[j]);
      const double dx = height(x + step, z) - height(x - step, z);
      const double dz = height(x, z + step) - height(x, z - step);
      mesh.set(i, j, static_cast<float>(height(x, z)),
               vec3(glm::normalize(dvec3(-dx, 2.0 * step, -dz))));
    }
  }
  return mesh;
}

}  // namespace aerostat::scatter
