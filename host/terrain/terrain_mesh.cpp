#include "terrain_mesh.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "core/stop_scope.hpp"
#include "terrain/scree.hpp"

namespace aerostat::terrain {
namespace {

constexpr float kScreeShare = 0.26f;  // of a wall's height that lies under its own stones

/// The vertices of a graded grid and a ring of further samples around them, from which the normals
/// at the rim are made.
class Samples {
 public:
  Samples(const scene::Terrain& terrain, const HeightField& field)
      : stride_(terrain.cells + 3), center_(terrain.center), field_(field) {
    const std::vector<double> axis = graded_axis(terrain.cells, terrain.size_m, terrain.grading);
    const double rim = axis[1] - axis[0];
    ground_.lines.push_back(static_cast<float>(axis.front() - rim));
    for (const double value : axis) ground_.lines.push_back(static_cast<float>(value));
    ground_.lines.push_back(static_cast<float>(axis.back() + rim));
    ground_.values.resize(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(stride_));
    tbb::parallel_for(0, stride_, [this, stop = current_stop()](int row) {
      stop_if_asked(stop);
      sample_row(row);
    });
    // Dunes slump by themselves.
    if (terrain.kind != scene::TerrainKind::dunes)
      lay_scree(ground_, kScreeShare * static_cast<float>(terrain.erosion));
  }

  /// i, j count from -1, the ring, to cells + 1.
  float height(int i, int j) const {
    return ground_.values[static_cast<std::size_t>(j + 1) * static_cast<std::size_t>(stride_) +
                          static_cast<std::size_t>(i + 1)];
  }

  std::vector<float> x() const { return lines(center_.x); }
  std::vector<float> z() const { return lines(center_.y); }

  vec3 normal(int i, int j) const {
    return glm::normalize(vec3(-slope(i, height(i - 1, j), height(i, j), height(i + 1, j)), 1.0f,
                               -slope(j, height(i, j - 1), height(i, j), height(i, j + 1))));
  }

 private:
  /// Slope at line k of the parabola through three heights: second order on unequal cells too.
  float slope(int k, float before, float here, float after) const {
    const float a = ground_.lines[k + 1] - ground_.lines[k];
    const float b = ground_.lines[k + 2] - ground_.lines[k + 1];
    return ((after - here) * a * a + (here - before) * b * b) / (a * b * (a + b));
  }

  /// The lines without the ring, in world coordinates.
  std::vector<float> lines(double center) const {
    std::vector<float> moved;
    for (std::size_t k = 1; k + 1 < ground_.lines.size(); ++k)
      moved.push_back(static_cast<float>(ground_.lines[k] + center));
    return moved;
  }

  float spacing(int line) const {
    const int k = std::clamp(line, 1, stride_ - 2);
    return 0.5f * (ground_.lines[k + 1] - ground_.lines[k - 1]);
  }

  void sample_row(int row) {
    Points points;
    Block height;
    for (int begin = 0; begin < stride_; begin += kBlockSize) {
      points.count = std::min(kBlockSize, stride_ - begin);
      for (int k = 0; k < points.count; ++k) {
        points.x[k] = ground_.lines[begin + k];
        points.z[k] = ground_.lines[row];
        points.spacing[k] = std::max(spacing(begin + k), spacing(row));
      }
      field_.heights(points, height);
      std::copy_n(height.begin(), points.count,
                  ground_.values.begin() + static_cast<std::ptrdiff_t>(row) * stride_ + begin);
    }
  }

  int stride_;
  dvec2 center_;
  const HeightField& field_;
  GradedHeights ground_;
};

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

mesh::GridMesh terrain_mesh(const scene::Terrain& terrain) {
  return terrain_mesh(terrain, HeightField(terrain));
}

mesh::GridMesh terrain_mesh(const scene::Terrain& terrain, const HeightField& field) {
  const Samples samples(terrain, field);
  mesh::GridMesh mesh(samples.x(), samples.z());
  tbb::parallel_for(0, terrain.cells + 1, [&](int j) {
    for (int i = 0; i <= terrain.cells; ++i) {
      mesh.set(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), samples.height(i, j),
               samples.normal(i, j));
    }
  });
  return mesh;
}

}  // namespace aerostat::terrain
