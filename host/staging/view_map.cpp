#include "staging/view_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <tbb/parallel_for.h>

namespace aerostat::staging {
namespace {

constexpr int kMostNodes = 321;

}  // namespace

ViewMap::ViewMap(const land::Land& land, const land::LandPoint& middle, double extent_m,
                 bool has_sea)
    : nodes_(std::clamp(static_cast<int>(extent_m / land.cell_m()) + 1, 33, kMostNodes)),
      spacing_m_(extent_m / (nodes_ - 1)) {
  const auto local = land.around(middle, 0.55 * extent_m);
  const std::size_t count = static_cast<std::size_t>(nodes_) * static_cast<std::size_t>(nodes_);
  heights_.resize(count);
  known_.resize(count);
  tbb::parallel_for(0, nodes_, [&](int j) {
    const auto side = static_cast<std::size_t>(nodes_);
    std::vector<float> x(side), z(side, static_cast<float>(at_node(j))),
        spacing(side, static_cast<float>(spacing_m_)), unused(side), unused_too(side);
    for (int i = 0; i < nodes_; ++i) x[i] = static_cast<float>(at_node(i));
    float* row = heights_.data() + static_cast<std::size_t>(j) * side;
    local->sample({x, z, spacing, {row, side}, unused, unused_too});
    for (int i = 0; i < nodes_; ++i) {
      if (has_sea) row[i] = std::max(row[i], 0.0f);
      known_[static_cast<std::size_t>(j) * side + static_cast<std::size_t>(i)] =
          local->is_known(at_node(i), at_node(j));
    }
  });
  bool found = false;
  for (std::size_t k = 0; k < count; ++k) {
    if (known_[k] == 0 || (found && heights_[k] <= summit_.y)) continue;
    found = true;
    const auto side = static_cast<std::size_t>(nodes_);
    summit_ = {at_node(static_cast<int>(k % side)), heights_[k],
               at_node(static_cast<int>(k / side))};
  }
}

std::size_t ViewMap::index(double x, double z) const {
  const auto node = [this](double at) {
    return static_cast<std::size_t>(
        std::clamp(std::round((at + half_m()) / spacing_m_), 0.0, nodes_ - 1.0));
  };
  return node(z) * static_cast<std::size_t>(nodes_) + node(x);
}

bool ViewMap::is_known(double x, double z) const {
  const double reach = half_m() + 0.5 * spacing_m_;
  return std::abs(x) <= reach && std::abs(z) <= reach && known_[index(x, z)] != 0;
}

float ViewMap::height(double x, double z) const {
  const auto place = [this](double at) {
    return std::clamp((at + half_m()) / spacing_m_, 0.0, nodes_ - 1.001);
  };
  const double u = place(x), v = place(z);
  const int i = static_cast<int>(u), j = static_cast<int>(v);
  const auto s = static_cast<float>(u - i), t = static_cast<float>(v - j);
  const float* row =
      heights_.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(nodes_);
  const float* next = row + nodes_;
  const float top = row[i] + s * (row[i + 1] - row[i]);
  return top + t * (next[i] + s * (next[i + 1] - next[i]) - top);
}

}  // namespace aerostat::staging
