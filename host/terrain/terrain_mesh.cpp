#include "terrain_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "core/simd.hpp"
#include "core/stop_scope.hpp"
#include "terrain/scree.hpp"

namespace aerostat::terrain {
namespace {

constexpr float kScreeShare = 0.26f;  // share of a wall's height under its own stones

/// The vertices of a graded grid with a ring of further samples around them, which the normals at
/// the rim need.
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
    for (int line = 0; line < stride_; ++line) spacings_.push_back(spacing(line));
    tbb::parallel_for(0, (stride_ + kTile - 1) / kTile, [this, stop = current_stop()](int rows) {
      stop_if_asked(stop);
      sample_rows(rows * kTile);
    });
    // Dunes get no scree, because their slip faces already lie at the angle of repose. Real land
    // has its own.
    if (terrain.kind != scene::TerrainKind::dunes && terrain.kind != scene::TerrainKind::elevation)
      lay_scree(ground_, kScreeShare * static_cast<float>(terrain.erosion));
  }

  /// Returns the heights of row j of the mesh, which is row j + 1 with the ring.
  std::span<const float> heights(int j) const {
    return std::span(row(j + 1) + 1, static_cast<std::size_t>(stride_) - 2);
  }

  std::vector<float> x() const { return lines(center_.x); }
  std::vector<float> z() const { return lines(center_.y); }

  /// Computes the normals of row j of the mesh.
  void normals(int j, std::span<vec3> normals) const {
    const float *above = row(j), *here = row(j + 1), *below = row(j + 2);
    const float* x = ground_.lines.data();
    const Gaps along_z{x[j + 1] - x[j], x[j + 2] - x[j + 1]};
    in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
      const int count = stride_ - 2;
      for (int i = 0; i < count; ++i) {
        const Gaps along_x{x[i + 1] - x[i], x[i + 2] - x[i + 1]};
        const float dx = slope(along_x, here[i], here[i + 1], here[i + 2]);
        const float dz = slope(along_z, above[i + 1], here[i + 1], below[i + 1]);
        const float share = 1.0f / std::sqrt(dx * dx + 1.0f + dz * dz);
        normals[i] = vec3(-dx * share, share, -dz * share);
      }
    });
  }

 private:
  /// The two gaps between three lines.
  struct Gaps {
    float a, b;
  };

  /// Returns the slope, at the middle of three lines, of the parabola through three heights. It
  /// is of second order on unequal cells too.
  AEROSTAT_INLINE static float slope(const Gaps& gaps, float before, float here, float after) {
    const float a = gaps.a, b = gaps.b;
    return ((after - here) * a * a + (here - before) * b * b) / (a * b * (a + b));
  }

  const float* row(int j) const {
    return ground_.values.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(stride_);
  }

  /// Returns the lines without the ring, moved to a centre. Far from the origin, single precision
  /// cannot tell fine cells apart. Cells become as wide as it can tell apart.
  std::vector<float> lines(double center) const {
    std::vector<float> moved;
    for (std::size_t k = 1; k + 1 < ground_.lines.size(); ++k) {
      const auto line = static_cast<float>(ground_.lines[k] + center);
      const float least = moved.empty() ? line : std::nextafter(moved.back(), kInfinity);
      moved.push_back(std::max(line, least));
    }
    return moved;
  }

  float spacing(int line) const {
    const int k = std::clamp(line, 1, stride_ - 2);
    return 0.5f * (ground_.lines[k + 1] - ground_.lines[k - 1]);
  }

  /// Samples kTile rows from `first` on, in squares of kTile x kTile points. Such points lie
  /// closer together than points of a row and more often share a cell of a noise.
  void sample_rows(int first) {
    const int end = std::min(first + kTile, stride_);
    Points points;
    Block height;
    std::array<int, kBlockSize> places;
    for (int i = 0; i < stride_; i += kTile) {
      for (int j = first; j < end; ++j)
        for (int k = i; k < std::min(i + kTile, stride_); ++k) {
          points.x[points.count] = ground_.lines[k];
          points.z[points.count] = ground_.lines[j];
          points.spacing[points.count] = std::max(spacings_[k], spacings_[j]);
          places[points.count++] = j * stride_ + k;
        }
      if (points.count + kTile * kTile <= kBlockSize && i + kTile < stride_) continue;
      field_.heights(points, height);
      for (int k = 0; k < points.count; ++k) ground_.values[places[k]] = height[k];
      points.count = 0;
    }
  }

  static constexpr int kTile = 4;

  int stride_;
  dvec2 center_;
  const HeightField& field_;
  GradedHeights ground_;
  std::vector<float> spacings_;  // spacings of the lines
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
  tbb::parallel_for(tbb::blocked_range<int>(0, terrain.cells + 1, 8), [&](const auto& rows) {
    std::vector<vec3> normals(static_cast<std::size_t>(terrain.cells) + 1);
    for (int j = rows.begin(); j != rows.end(); ++j) {
      samples.normals(j, normals);
      mesh.set_row(static_cast<std::uint32_t>(j), samples.heights(j), normals);
    }
  });
  return mesh;
}

}  // namespace aerostat::terrain
