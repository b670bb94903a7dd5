#include "scatter/circles.hpp"

#include <algorithm>
#include <cmath>

namespace aerostat::scatter {
namespace {

/// The most squares along a side.
constexpr double kMostSquares = 1024.0;

}  // namespace

void Circles::index(double most_reach_m) {
  first_.clear();
  members_.clear();
  if (circles_.empty()) return;
  least_ = dvec2(1e300);
  dvec2 most(-1e300);
  for (const KeepOut& circle : circles_) {
    least_ = glm::min(least_, circle.center - circle.radius_m - most_reach_m);
    most = glm::max(most, circle.center + circle.radius_m + most_reach_m);
  }
  const dvec2 size = most - least_;
  const double wanted = 2.0 * std::sqrt(static_cast<double>(circles_.size()));
  square_m_ = std::max(std::max(size.x, size.y) / std::clamp(wanted, 1.0, kMostSquares), 1e-3);
  columns_ = static_cast<std::size_t>(size.x / square_m_) + 1;
  rows_ = static_cast<std::size_t>(size.y / square_m_) + 1;
  const auto for_squares = [this, most_reach_m](const KeepOut& circle, const auto& visit) {
    const double radius_m = circle.radius_m + most_reach_m;
    const dvec2 from = (circle.center - radius_m - least_) / square_m_;
    const dvec2 to = (circle.center + radius_m - least_) / square_m_;
    const auto last = [](double place, std::size_t count) {
      return std::min(static_cast<std::size_t>(std::max(place, 0.0)), count - 1);
    };
    for (std::size_t j = last(from.y, rows_); j <= last(to.y, rows_); ++j) {
      for (std::size_t i = last(from.x, columns_); i <= last(to.x, columns_); ++i) {
        visit(j * columns_ + i);
      }
    }
  };
  first_.assign(columns_ * rows_ + 1, 0);
  for (const KeepOut& circle : circles_) {
    for_squares(circle, [this](std::size_t square) { ++first_[square + 1]; });
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  members_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < circles_.size(); ++k) {
    for_squares(circles_[k], [&](std::size_t square) { members_[next[square]++] = k; });
  }
}

bool Circles::hold(const dvec2& point, double reach_m) const {
  const dvec2 at = (point - least_) / square_m_;
  if (columns_ == 0 || at.x < 0.0 || at.y < 0.0) return false;
  const auto i = static_cast<std::size_t>(at.x), j = static_cast<std::size_t>(at.y);
  if (i >= columns_ || j >= rows_) return false;
  const std::size_t square = j * columns_ + i;
  for (std::size_t k = first_[square]; k < first_[square + 1]; ++k) {
    const KeepOut& circle = circles_[members_[k]];
    if (glm::distance(point, circle.center) < circle.radius_m + reach_m) return true;
  }
  return false;
}

}  // namespace aerostat::scatter
