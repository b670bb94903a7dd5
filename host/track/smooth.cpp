#include "track/smooth.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace aerostat::track {

namespace {

/// Bounds the work where a file has many fixes in a moment.
constexpr std::size_t kMostNeighbours = 300;

/// The sums of a line fitted through weighted points.
struct LineFit {
  double weight = 0.0, time = 0.0, time2 = 0.0, value = 0.0, both = 0.0;

  void add(double t, double v, double w) {
    weight += w;
    time += w * t;
    time2 += w * t * t;
    value += w * v;
    both += w * t * v;
  }
  /// Returns the line's value at the time 0.
  double at_zero() const {
    const double determinant = weight * time2 - time * time;
    if (determinant <= 1e-9 * weight * weight) return value / weight;
    return (value * time2 - both * time) / determinant;
  }
};

/// Returns the slope of the curve at an inner point, or at an end the slope of its only side.
double slope_at(const std::vector<double>& times, const std::vector<double>& values,
                std::size_t i) {
  const auto slope = [&](std::size_t k) {
    return (values[k + 1] - values[k]) / (times[k + 1] - times[k]);
  };
  if (i == 0) return slope(0);
  if (i + 1 == times.size()) return slope(i - 1);
  const double before = slope(i - 1), behind = slope(i);
  if (before * behind <= 0.0) return 0.0;
  const double h0 = times[i] - times[i - 1], h1 = times[i + 1] - times[i];
  const double w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
  return (w0 + w1) / (w0 / before + w1 / behind);
}

}  // namespace

std::vector<double> smoothed(const std::vector<double>& times, const std::vector<double>& values,
                             double window) {
  if (!(window > 0.0)) return values;
  const double half = 0.5 * window;
  std::vector<double> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    LineFit fit;
    const auto add = [&](std::size_t k) {
      const double share = std::abs(times[k] - times[i]) / half;
      if (share >= 1.0) return false;
      const double rest = 1.0 - share * share * share;
      fit.add(times[k] - times[i], values[k] - values[i], rest * rest * rest);
      return true;
    };
    add(i);
    const std::size_t least = i - std::min(i, kMostNeighbours);
    const std::size_t most = std::min(values.size() - i, kMostNeighbours) + i;
    for (std::size_t k = i; k > least && add(k - 1);) --k;
    for (std::size_t k = i + 1; k < most && add(k);) ++k;
    result[i] = values[i] + fit.at_zero();
  }
  return result;
}

double value_at(const std::vector<double>& times, const std::vector<double>& values, double time) {
  if (time <= times.front()) return values.front();
  if (time >= times.back()) return values.back();
  const auto next = std::upper_bound(times.begin(), times.end(), time);
  const auto i = static_cast<std::size_t>(next - times.begin()) - 1;
  const double step = times[i + 1] - times[i];
  const double s = (time - times[i]) / step, r = 1.0 - s;
  const double value = values[i] * (1.0 + 2.0 * s) * r * r +
                       values[i + 1] * (3.0 - 2.0 * s) * s * s +
                       slope_at(times, values, i) * step * s * r * r -
                       slope_at(times, values, i + 1) * step * s * s * r;
  const auto [low, high] = std::minmax(values[i], values[i + 1]);
  return std::clamp(value, low, high);
}

}  // namespace aerostat::track
