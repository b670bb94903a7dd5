#include "film/wind.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace aerostat::film {
namespace {

constexpr double kDriftStep_s = 0.1;
/// The step of a chase, which is short beside a frame.
constexpr double kChaseStep_s = 0.02;

dvec2 velocity_of(const scene::WindLayer& layer) {
  const double from = glm::radians(layer.from_deg);
  return layer.speed_m_s * dvec2(-std::sin(from), std::cos(from));
}

}  // namespace

dvec2 wind_at(const std::vector<scene::WindLayer>& layers, double height_m) {
  if (layers.empty()) return dvec2(0.0);
  const auto above = std::upper_bound(
      layers.begin(), layers.end(), height_m,
      [](double height, const scene::WindLayer& layer) { return height < layer.height_m; });
  if (above == layers.begin()) return velocity_of(*above);
  const scene::WindLayer& below = *std::prev(above);
  if (above == layers.end()) return velocity_of(below);
  const double share = (height_m - below.height_m) / (above->height_m - below.height_m);
  return glm::mix(velocity_of(below), velocity_of(*above), share);
}

Drift::Drift(std::vector<scene::WindLayer> layers, Height height)
    : layers_(std::move(layers)), height_(std::move(height)) {}

dvec2 Drift::velocity(double time_s) const {
  return wind_at(layers_, height_(time_s));
}

dvec2 Drift::at(double time_s) {
  if (layers_.empty()) return dvec2(0.0);
  const auto whole = static_cast<std::size_t>(std::floor(time_s / kDriftStep_s));
  while (ways_.size() <= whole) {
    const double middle = (static_cast<double>(ways_.size()) - 0.5) * kDriftStep_s;
    ways_.push_back(ways_.back() + kDriftStep_s * velocity(middle));
  }
  const double start = static_cast<double>(whole) * kDriftStep_s, rest = time_s - start;
  return ways_[whole] + rest * velocity(start + 0.5 * rest);
}

Chase::Chase(Place place, double lag_s)
    : place_(std::move(place)), lag_s_(lag_s), steps_{place_(0.0)} {}

dvec3 Chase::at(double time_s) {
  if (!(lag_s_ > 0.0)) return place_(time_s);
  const auto whole = static_cast<std::size_t>(std::floor(time_s / kChaseStep_s));
  const auto next = [this](const dvec3& from, double until_s, double step_s) {
    return glm::mix(place_(until_s), from, std::exp(-step_s / lag_s_));
  };
  while (steps_.size() <= whole) {
    const double until = static_cast<double>(steps_.size()) * kChaseStep_s;
    steps_.push_back(next(steps_.back(), until, kChaseStep_s));
  }
  const double start = static_cast<double>(whole) * kChaseStep_s;
  return next(steps_[whole], time_s, time_s - start);
}

}  // namespace aerostat::film
