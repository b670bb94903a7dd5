#include "scatter/surface.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace aerostat::scatter {
namespace {

/// The cell of ascending lines that holds a value, and where in it, 0 to 1.
struct Place {
  std::size_t cell;
  float share;
};

Place place_between(const std::vector<float>& lines, double value) {
  const auto next = std::upper_bound(lines.begin() + 1, lines.end() - 1, value,
                                     [](double v, float line) { return v < line; });
  const auto cell = static_cast<std::size_t>(next - lines.begin()) - 1;
  const double share = (value - lines[cell]) / (double{lines[cell + 1]} - lines[cell]);
  return {cell, static_cast<float>(std::clamp(share, 0.0, 1.0))};
}

}  // namespace

Surface::Surface(const mesh::TriangleMesh& ground, int cells)
    : ground_(ground), side_(static_cast<std::size_t>(cells) + 1) {
  if (cells < 1 || ground.positions.size() != side_ * side_) {
    throw Error(ErrorKind::internal, "scatter: the ground is not a mesh of so many cells");
  }
  for (std::size_t k = 0; k < side_; ++k) {
    x_.push_back(ground.positions[vertex(k, 0)].x);
    z_.push_back(ground.positions[vertex(0, k)].z);
  }
}

bool Surface::covers(double x, double z) const {
  const auto within = [](const std::vector<float>& lines, double value) {
    return value >= static_cast<double>(lines.front()) &&
           value <= static_cast<double>(lines.back());
  };
  return within(x_, x) && within(z_, z);
}

SurfacePoint Surface::at(double x, double z) const {
  const Place u = place_between(x_, x), v = place_between(z_, z);
  const std::size_t a = vertex(u.cell, v.cell), b = a + 1, c = a + side_, d = c + 1;
  const auto height = [this](std::size_t i) { return ground_.positions[i].y; };
  // Cells are split as terrain_mesh splits them, along the diagonal that is less steep.
  float weight[4];  // of a, b, c, d
  if (std::fabs(height(a) - height(d)) <= std::fabs(height(b) - height(c))) {
    const float both = std::min(u.share, v.share);
    weight[0] = 1.0f - std::max(u.share, v.share);
    weight[1] = u.share - both;
    weight[2] = v.share - both;
    weight[3] = both;
  } else {
    const float beyond = std::max(u.share + v.share - 1.0f, 0.0f);
    weight[0] = std::max(1.0f - u.share - v.share, 0.0f);
    weight[1] = u.share - beyond;
    weight[2] = v.share - beyond;
    weight[3] = beyond;
  }
  SurfacePoint point;
  point.position = {
      static_cast<float>(x),
      weight[0] * height(a) + weight[1] * height(b) + weight[2] * height(c) + weight[3] * height(d),
      static_cast<float>(z)};
  point.normal = glm::normalize(weight[0] * ground_.normals[a] + weight[1] * ground_.normals[b] +
                                weight[2] * ground_.normals[c] + weight[3] * ground_.normals[d]);
  return point;
}

}  // namespace aerostat::scatter
