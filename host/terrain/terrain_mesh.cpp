#include "terrain_mesh.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "core/error.hpp"

namespace aerostat::terrain {
namespace {

/// The vertices of a graded grid and a ring of further samples around them, from which the normals
/// at the rim are made.
class Grid {
 public:
  Grid(const scene::Terrain& terrain, const HeightField& field)
      : stride_(terrain.cells + 3), center_(terrain.center), field_(field) {
    const std::vector<double> axis = graded_axis(terrain.cells, terrain.size_m, terrain.grading);
    const double rim = axis[1] - axis[0];
    line_.push_back(static_cast<float>(axis.front() - rim));
    for (const double value : axis) line_.push_back(static_cast<float>(value));
    line_.push_back(static_cast<float>(axis.back() + rim));
    heights_.resize(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(stride_));
    tbb::parallel_for(0, stride_, [this](int row) { sample_row(row); });
  }

  /// i, j count from -1, the ring, to cells + 1.
  float height(int i, int j) const {
    return heights_[static_cast<std::size_t>(j + 1) * static_cast<std::size_t>(stride_) +
                    static_cast<std::size_t>(i + 1)];
  }

  vec3 position(int i, int j) const {
    return {static_cast<float>(line_[i + 1] + center_.x), height(i, j),
            static_cast<float>(line_[j + 1] + center_.y)};
  }

  vec3 normal(int i, int j) const {
    return glm::normalize(vec3(-slope(i, height(i - 1, j), height(i, j), height(i + 1, j)), 1.0f,
                               -slope(j, height(i, j - 1), height(i, j), height(i, j + 1))));
  }

 private:
  /// Slope at line k of the parabola through three heights: second order on unequal cells too.
  float slope(int k, float before, float here, float after) const {
    const float a = line_[k + 1] - line_[k];
    const float b = line_[k + 2] - line_[k + 1];
    return ((after - here) * a * a + (here - before) * b * b) / (a * b * (a + b));
  }

  float spacing(int line) const {
    const int k = std::clamp(line, 1, stride_ - 2);
    return 0.5f * (line_[k + 1] - line_[k - 1]);
  }

  void sample_row(int row) {
    Points points;
    Block height;
    for (int begin = 0; begin < stride_; begin += kBlockSize) {
      points.count = std::min(kBlockSize, stride_ - begin);
      for (int k = 0; k < points.count; ++k) {
        points.x[k] = line_[begin + k];
        points.z[k] = line_[row];
        points.spacing[k] = std::max(spacing(begin + k), spacing(row));
      }
      field_.heights(points, height);
      std::copy_n(height.begin(), points.count,
                  heights_.begin() + static_cast<std::ptrdiff_t>(row) * stride_ + begin);
    }
  }

  int stride_;
  dvec2 center_;
  const HeightField& field_;
  std::vector<float> line_;
  std::vector<float> heights_;
};

void fill_row(const Grid& grid, int cells, int j, mesh::TriangleMesh& mesh) {
  const std::size_t first = static_cast<std::size_t>(j) * static_cast<std::size_t>(cells + 1);
  for (int i = 0; i <= cells; ++i) {
    mesh.positions[first + i] = grid.position(i, j);
    mesh.normals[first + i] = grid.normal(i, j);
  }
}

void split_row(int cells, int j, mesh::TriangleMesh& mesh) {
  const auto side = static_cast<std::uint32_t>(cells + 1);
  uvec3* out = &mesh.triangles[2u * static_cast<std::size_t>(j) * static_cast<std::size_t>(cells)];
  for (int i = 0; i < cells; ++i) {
    const std::uint32_t a = static_cast<std::uint32_t>(j) * side + static_cast<std::uint32_t>(i);
    const std::uint32_t b = a + 1;
    const std::uint32_t c = a + side;
    const std::uint32_t d = c + 1;
    // The two diagonals differ in height alone.
    const float ad = std::fabs(mesh.positions[a].y - mesh.positions[d].y);
    const float bc = std::fabs(mesh.positions[b].y - mesh.positions[c].y);
    *out++ = ad <= bc ? uvec3(a, c, d) : uvec3(a, c, b);
    *out++ = ad <= bc ? uvec3(a, d, b) : uvec3(b, c, d);
  }
}

}  // namespace

std::vector<double> graded_axis(int cells, double size_m, double grading) {
  if (cells < 1 || !(size_m > 0.0) || !(grading >= 1.0))
    throw Error(ErrorKind::bad_data,
                "cannot lay out the terrain's grid: cells must be >= 1, size_m > 0 and grading >= "
                "1");
  const double middle = 0.5 * (cells - 1);
  const double nearest = cells % 2 == 0 ? 0.5 : 0.0;
  const double steps = std::max(middle - nearest, 1.0);
  std::vector<double> sizes(static_cast<std::size_t>(cells));
  double sum = 0.0;
  for (int i = 0; i < cells; ++i) {
    sizes[i] = std::pow(grading, (std::fabs(i - middle) - nearest) / steps);
    sum += sizes[i];
  }
  std::vector<double> axis(sizes.size() + 1);
  const int half = cells / 2;
  double at = 0.5 * size_m;
  for (int i = 0; i <= half; ++i) {
    axis[i] = -at;
    axis[cells - i] = at;
    at -= sizes[i] * size_m / sum;
  }
  if (cells % 2 == 0) axis[half] = 0.0;
  return axis;
}

mesh::TriangleMesh terrain_mesh(const scene::Terrain& terrain) {
  return terrain_mesh(terrain, HeightField(terrain));
}

mesh::TriangleMesh terrain_mesh(const scene::Terrain& terrain, const HeightField& field) {
  const Grid grid(terrain, field);
  const auto side = static_cast<std::size_t>(terrain.cells) + 1;
  mesh::TriangleMesh mesh;
  mesh.positions.resize(side * side);
  mesh.normals.resize(side * side);
  mesh.triangles.resize(2 * (side - 1) * (side - 1));
  tbb::parallel_for(0, terrain.cells + 1, [&](int j) { fill_row(grid, terrain.cells, j, mesh); });
  tbb::parallel_for(0, terrain.cells, [&](int j) { split_row(terrain.cells, j, mesh); });
  return mesh;
}

}  // namespace aerostat::terrain
