#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/array.hpp"
#include "core/math.hpp"
#include "mesh/mesh.hpp"

namespace aerostat::mesh {

/// A surface of heights over the cells of a grid, with 8 bytes for each vertex. Vertex (i, j)
/// lies on the i-th line of x and the j-th line of z. kernels/shared/height_grid.h describes the
/// layout in memory and the triangles of a cell.
class GridMesh {
 public:
  GridMesh() = default;
  /// Makes a grid over these lines, whose vertices have no value yet. The lines are in metres and
  /// ascending, at least two of each. Throws Error{internal} on other lines or on more than 16384
  /// cells along a side.
  GridMesh(std::span<const float> x, std::span<const float> z);

  std::uint32_t columns() const { return columns_; }
  std::uint32_t rows() const { return rows_; }
  std::uint64_t triangles() const { return std::uint64_t{2} * columns_ * rows_; }

  /// Sets a vertex. `normal` is a unit vector with normal.y > 0, which is stored with an error of
  /// some 3e-5. Different vertices may be set from different threads.
  void set(std::uint32_t i, std::uint32_t j, float height, const vec3& normal);

  /// Sets a whole row of columns() + 1 vertices. Different rows may be set from different
  /// threads.
  void set_row(std::uint32_t j, std::span<const float> heights, std::span<const vec3> normals);

  float x(std::uint32_t i) const { return x_[i]; }
  float z(std::uint32_t j) const { return z_[j]; }
  float height(std::uint32_t i, std::uint32_t j) const { return words_[first_height_ + at(i, j)]; }
  vec3 position(std::uint32_t i, std::uint32_t j) const { return {x(i), height(i, j), z(j)}; }
  vec3 normal(std::uint32_t i, std::uint32_t j) const;

  /// Returns the words that the kernels read.
  std::span<const float> words() const { return words_; }

 private:
  std::size_t at(std::uint32_t i, std::uint32_t j) const { return std::size_t{j} * stride_ + i; }

  std::uint32_t columns_ = 0, rows_ = 0;
  std::uint32_t padded_columns_ = 0, padded_rows_ = 0;
  std::size_t stride_ = 0, first_height_ = 0, first_normal_ = 0;
  std::vector<float> x_, z_;
  Array<float> words_;
};

/// Returns the grid as triangles. Vertex (i, j) has the index j (columns + 1) + i. The triangles
/// of cell (i, j) have the indices 2 (j columns + i) and 2 (j columns + i) + 1.
TriangleMesh to_triangles(const GridMesh& grid);

}  // namespace aerostat::mesh
