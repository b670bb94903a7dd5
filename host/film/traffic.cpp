#include "film/traffic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace aerostat::film {
namespace {

constexpr double kStep_s = 0.1;
constexpr double kMostSteps = 2000.0;

}  // namespace

Traffic::Traffic(double duration_s)
    : step_s_(std::max(kStep_s, duration_s / kMostSteps)),
      steps_(static_cast<int>(std::ceil(duration_s / step_s_))) {}

Traffic::Way Traffic::way_of(const std::function<dvec3(double time_s)>& place) const {
  Way way;
  for (int i = 0; i <= steps_; ++i) way.push_back(place(i * step_s_));
  return way;
}

double Traffic::least_distance(const Way& way) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Way& other : ways_) {
    for (std::size_t i = 0; i < way.size(); ++i) {
      least = std::min(least, glm::distance(way[i], other[i]));
    }
  }
  return least;
}

}  // namespace aerostat::film
