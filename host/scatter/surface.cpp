#include "scatter/surface.hpp"

#include <algorithm>
#include <cmath>

namespace aerostat::scatter {
namespace {

/// The cell of ascending lines that holds a value, and where in it, 0 to 1.
struct Place {
  std::uint32_t cell;
  float share;
};

Place place_between(const std::vector<float>& lines, double value) {
  const auto next = std::upper_bound(lines.begin() + 1, lines.end() - 1, value,
                                     [](double v, float line) { return v < line; });
  const auto cell = static_cast<std::uint32_t>(next - lines.begin()) - 1;
  const double share = (value - lines[cell]) / (double{lines[cell + 1]} - lines[cell]);
  return {cell, static_cast<float>(std::clamp(share, 0.0, 1.0))};
}

}  // namespace

Surface::Surface(const mesh::GridMesh& ground) : ground_(ground) {
  for (std::uint32_t i = 0; i <= ground.columns(); ++i) x_.push_back(ground.x(i));
  for (std::uint32_t j = 0; j <= ground.rows(); ++j) z_.push_back(ground.z(j));
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
  const std::uint32_t i = u.cell, j = v.cell;
  const float a = ground_.height(i, j), b = ground_.height(i + 1, j);
  const float c = ground_.height(i, j + 1), d = ground_.height(i + 1, j + 1);
  // Cells are split along the diagonal that is less steep.
  float weight[4];  // of a, b, c, d
  if (std::fabs(a - d) <= std::fabs(b - c)) {
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
  point.position = {static_cast<float>(x),
                    weight[0] * a + weight[1] * b + weight[2] * c + weight[3] * d,
                    static_cast<float>(z)};
  point.normal = glm::normalize(
      weight[0] * ground_.normal(i, j) + weight[1] * ground_.normal(i + 1, j) +
      weight[2] * ground_.normal(i, j + 1) + weight[3] * ground_.normal(i + 1, j + 1));
  return point;
}

}  // namespace aerostat::scatter
