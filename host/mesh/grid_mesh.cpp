#include "mesh/grid_mesh.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/simd.hpp"
#include "height_grid.h"
#include "rules/height_cell.h"

namespace aerostat::mesh {
namespace {

std::uint32_t checked_cells(std::span<const float> lines, const char* axis) {
  const bool ascending = std::adjacent_find(lines.begin(), lines.end(), [](float a, float b) {
                           return !(a < b);
                         }) == lines.end();
  if (lines.size() >= 2 && lines.size() <= AERO_GRID_MOST + 1 && ascending)
    return static_cast<std::uint32_t>(lines.size() - 1);
  throw Error(ErrorKind::internal, "a grid's lines of " + std::string(axis) +
                                       " must ascend and be 2 to " +
                                       std::to_string(AERO_GRID_MOST + 1) +
                                       " in number; there are " + std::to_string(lines.size()));
}

std::uint32_t padded(std::uint32_t cells) {
  return (cells + AERO_GRID_BLOCK - 1) / AERO_GRID_BLOCK * AERO_GRID_BLOCK;
}

/// Copies the lines and repeats the last one up to the padded number. Returns the end of the
/// copies.
float* put_lines(std::span<const float> lines, std::uint32_t padded_cells, float* to) {
  float* const end = to + padded_cells + 1;
  std::fill(std::copy(lines.begin(), lines.end(), to), end, lines.back());
  return end;
}

/// Returns 32767 times the share, rounded to the nearest integer as by std::lround. Loops with
/// this function can be vectorised.
AEROSTAT_INLINE std::uint32_t as_short(float share) {
  const double scaled = share * 32767.0f;
  const auto nearest = static_cast<std::int32_t>(scaled + (scaled < 0.0 ? -0.5 : 0.5));
  return static_cast<std::uint32_t>(nearest) & 0xffffu;
}

AEROSTAT_INLINE float packed(const vec3& normal) {
  const float sum = std::fabs(normal.x) + std::fabs(normal.y) + std::fabs(normal.z);
  return std::bit_cast<float>(as_short(normal.x / sum) | as_short(normal.z / sum) << 16);
}

}  // namespace

GridMesh::GridMesh(std::span<const float> x, std::span<const float> z)
    : columns_(checked_cells(x, "x")),
      rows_(checked_cells(z, "z")),
      padded_columns_(padded(columns_)),
      padded_rows_(padded(rows_)),
      stride_(std::size_t{padded_columns_} + 1),
      first_height_(AERO_GRID_HEADER + stride_ + padded_rows_ + 1),
      first_normal_(first_height_ + stride_ * (std::size_t{padded_rows_} + 1)),
      x_(x.begin(), x.end()),
      z_(z.begin(), z.end()) {
  words_.resize(2 * first_normal_ - first_height_ + AERO_GRID_SLACK);
  words_[0] = std::bit_cast<float>(padded_columns_);
  words_[1] = std::bit_cast<float>(padded_rows_);
  put_lines(z, padded_rows_, put_lines(x, padded_columns_, words_.data() + AERO_GRID_HEADER));
  std::fill_n(words_.end() - AERO_GRID_SLACK, AERO_GRID_SLACK, 0.0f);
}

void GridMesh::set(std::uint32_t i, std::uint32_t j, float height, const vec3& normal) {
  const float word = packed(normal);
  // The vertices at the rim are repeated to fill up the last blocks.
  const std::uint32_t last_i = i == columns_ ? padded_columns_ : i;
  const std::uint32_t last_j = j == rows_ ? padded_rows_ : j;
  for (std::uint32_t row = j; row <= last_j; ++row) {
    for (std::uint32_t column = i; column <= last_i; ++column) {
      words_[first_height_ + at(column, row)] = height;
      words_[first_normal_ + at(column, row)] = word;
    }
  }
}

void GridMesh::set_row(std::uint32_t j, std::span<const float> heights,
                       std::span<const vec3> normals) {
  float* const to_heights = &words_[first_height_ + at(0, j)];
  float* const to_normals = &words_[first_normal_ + at(0, j)];
  std::copy(heights.begin(), heights.end(), to_heights);
  in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
    const float* from = &normals[0].x;
    const auto count = static_cast<std::int32_t>(normals.size());
    for (std::int32_t i = 0; i < count; ++i)
      to_normals[i] = packed({from[3 * i], from[3 * i + 1], from[3 * i + 2]});
  });
  // The vertices at the rim are repeated to fill up the last blocks.
  std::fill(to_heights + heights.size(), to_heights + stride_, heights.back());
  std::fill(to_normals + normals.size(), to_normals + stride_, to_normals[normals.size() - 1]);
  for (std::uint32_t row = j + 1; j == rows_ && row <= padded_rows_; ++row) {
    std::copy_n(to_heights, stride_, &words_[first_height_ + at(0, row)]);
    std::copy_n(to_normals, stride_, &words_[first_normal_ + at(0, row)]);
  }
}

vec3 GridMesh::normal(std::uint32_t i, std::uint32_t j) const {
  const auto bits = std::bit_cast<std::uint32_t>(words_[first_normal_ + at(i, j)]);
  const float nx = rules::packed_normal_x(bits), nz = rules::packed_normal_z(bits);
  return glm::normalize(vec3(nx, 1.0f - std::fabs(nx) - std::fabs(nz), nz));
}

TriangleMesh to_triangles(const GridMesh& grid) {
  TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= grid.rows(); ++j) {
    for (std::uint32_t i = 0; i <= grid.columns(); ++i) {
      mesh.positions.push_back(grid.position(i, j));
      mesh.normals.push_back(grid.normal(i, j));
    }
  }
  mesh.triangles.reserve(grid.triangles());
  const std::uint32_t row = grid.columns() + 1;
  for (std::uint32_t j = 0; j < grid.rows(); ++j) {
    for (std::uint32_t i = 0; i < grid.columns(); ++i) {
      const std::uint32_t a = j * row + i, b = a + 1, c = a + row, d = c + 1;
      const auto along_ad = rules::cell_along_ad(grid.height(i, j), grid.height(i + 1, j),
                                                 grid.height(i, j + 1), grid.height(i + 1, j + 1));
      std::uint32_t corner[4];
      CELL_CORNERS(rules::lane_select, along_ad, a, b, c, d, corner);
      mesh.triangles.emplace_back(corner[0], corner[1], corner[2]);
      mesh.triangles.emplace_back(corner[0], corner[2], corner[3]);
    }
  }
  return mesh;
}

}  // namespace aerostat::mesh
