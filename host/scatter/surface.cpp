#include "scatter/surface.hpp"

#include <algorithm>

#include "rules/height_cell.h"

namespace aerostat::scatter {
void Lines::index() {
  const std::size_t parts = lines_.size() - 1;
  const double extent = double{lines_.back()} - lines_.front();
  parts_per_m_ = static_cast<double>(parts) / extent;
  std::uint32_t cell = 0;
  for (std::size_t k = 0; k < parts; ++k) {
    const double from = lines_.front() + static_cast<double>(k) / parts_per_m_;
    while (cell + 2 < lines_.size() && static_cast<double>(lines_[cell + 1]) <= from) ++cell;
    first_.push_back(cell);
  }
}

Lines::Place Lines::at(double value) const {
  const double part = (value - static_cast<double>(lines_.front())) * parts_per_m_;
  const auto most = static_cast<double>(first_.size() - 1);
  std::uint32_t cell = first_[static_cast<std::size_t>(std::clamp(part, 0.0, most))];
  while (cell + 2 < lines_.size() && static_cast<double>(lines_[cell + 1]) <= value) ++cell;
  // The index may be too high by some cells, because the end of a part is rounded.
  while (cell > 0 && static_cast<double>(lines_[cell]) > value) --cell;
  const double share = (value - lines_[cell]) / (double{lines_[cell + 1]} - lines_[cell]);
  return {cell, static_cast<float>(std::clamp(share, 0.0, 1.0))};
}

Surface::Surface(const mesh::GridMesh& ground, const dvec3& origin)
    : ground_(ground), origin_(origin) {
  for (std::uint32_t i = 0; i <= ground.columns(); ++i) x_.add(ground.x(i));
  for (std::uint32_t j = 0; j <= ground.rows(); ++j) z_.add(ground.z(j));
  x_.index();
  z_.index();
}

bool Surface::covers(double x, double z) const {
  return x_.cover(x - origin_.x) && z_.cover(z - origin_.z);
}

void Surface::find(double x, double z, Spot& spot) const {
  const double mesh_x = x - origin_.x, mesh_z = z - origin_.z;
  const Lines::Place u = x_.at(mesh_x), v = z_.at(mesh_z);
  const std::uint32_t i = spot.i = u.cell, j = spot.j = v.cell;
  const float a = ground_.height(i, j), b = ground_.height(i + 1, j);
  const float c = ground_.height(i, j + 1), d = ground_.height(i + 1, j + 1);
  float(&weight)[4] = spot.weight;
  if (rules::cell_along_ad(a, b, c, d) != 0) {
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
  spot.position = {static_cast<float>(mesh_x),
                   weight[0] * a + weight[1] * b + weight[2] * c + weight[3] * d,
                   static_cast<float>(mesh_z)};
}

vec3 Surface::normal(const Spot& spot) const {
  const std::uint32_t i = spot.i, j = spot.j;
  const auto& weight = spot.weight;
  return glm::normalize(weight[0] * ground_.normal(i, j) + weight[1] * ground_.normal(i + 1, j) +
                        weight[2] * ground_.normal(i, j + 1) +
                        weight[3] * ground_.normal(i + 1, j + 1));
}

}  // namespace aerostat::scatter
