#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/array.hpp"
#include "core/math.hpp"
#include "mesh/mesh.hpp"

namespace aerostat::mesh {

/// A surface of heights over the cells of a grid, in 8 bytes a vertex: kernels/shared/height_grid.h
/// says how it lies in memory and how cells are split into triangles. Vertex (i, j) lies on the
/// i-th line of x and the j-th of z.
class GridMesh {
 public:
  GridMesh() = default;
  /// A grid over these lines (metres, ascending, at least two of each), whose vertices have no
  /// value yet. Throws Error{internal} on other lines or more than 16384 cells along a side.
  GridMesh(std::span<const float> x, std::span<const float> z);

  std::uint32_t columns() const { return columns_; }
  std::uint32_t rows() const { return rows_; }
  std::uint64_t triangles() const { return std::uint64_t{2} * columns_ * rows_; }

  /// Sets a vertex; `normal` is a unit vector with normal.y > 0, kept to some 3e-5. Different
  /// vertices may be set from different threads.
  void set(std::uint32_t i, std::uint32_t j, float height, const vec3& normal);

  /// The same for a whole row, columns() + 1 vertices of it.
  void set_row(std::uint32_t j, std::span<const float> heights, std::span<const vec3> normals);

  float x(std::uint32_t i) const { return x_[i]; }
  float z(std::uint32_t j) const { return z_[j]; }
  float height(std::uint32_t i, std::uint32_t j) const { return words_[first_height_ + at(i, j)]; }
  vec3 position(std::uint32_t i, std::uint32_t j) const { return {x(i), height(i, j), z(j)}; }
  vec3 normal(std::uint32_t i, std::uint32_t j) const;

  /// What the kernels read.
  std::span<const float> words() const { return words_; }

 private:
  std::size_t at(std::uint32_t i, std::uint32_t j) const { return std::size_t{j} * stride_ + i; }

  std::uint32_t columns_ = 0, rows_ = 0;
  std::uint32_t padded_columns_ = 0, padded_rows_ = 0;
  std::size_t stride_ = 0, first_height_ = 0, first_normal_ = 0;
  std::vector<float> x_, z_;
  Array<float> words_;
};

/// The grid as triangles: vertex (i, j) at j (columns + 1) + i, cell (i, j) at
/// 2 (j columns + i) and the one after.
TriangleMesh to_triangles(const GridMesh& grid);

}  // namespace aerostat::mesh
