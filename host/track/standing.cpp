#include "track/standing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "track/distance.hpp"

namespace aerostat::track {

namespace {

constexpr double kRadius_m = 30.0;  // receivers wander that far while they lie still
constexpr double kHeight_m = 15.0;
constexpr double kAway_s = 30.0;
constexpr std::size_t kFixesAway = 5;
constexpr double kShortWindow_s = 10.0, kLongWindow_s = 60.0;  // the middle is found from these
constexpr std::size_t kMostInWindow = 60;
constexpr double kMostInside = 0.8;  // this share of the window lies around its middle
constexpr double kWander_m = 6.0;    // within seconds
constexpr double kCreep_mps = 0.5;   // whoever is faster moves
constexpr std::size_t kFewestAtRest = 3;
constexpr double kRest_s = 10.0, kShortRest_s = 2.0;

/// The fixes of a track from one of its ends.
class FromEnd {
 public:
  FromEnd(const std::vector<Fix>& fixes, bool is_reversed, double window_s)
      : fixes_(fixes), is_reversed_(is_reversed) {
    find_middle(window_s);
  }

  std::size_t size() const { return fixes_.size(); }
  const Fix& at(std::size_t i) const { return fixes_[is_reversed_ ? size() - 1 - i : i]; }
  double seconds(std::size_t from, std::size_t to) const {
    return std::abs(*at(to).time_s - *at(from).time_s);
  }
  double distance(std::size_t i) const { return distance_m(middle_, at(i).place); }
  double rise(std::size_t i) const {
    const auto height = any_height(at(i));
    return height && height_ ? std::abs(*height - *height_) : 0.0;
  }
  /// Returns whether the fixes from which the middle was found lie around it.
  bool begins_inside() const {
    std::size_t inside = 0;
    for (std::size_t i = 0; i < window_; ++i) inside += is_away(i) ? 0 : 1;
    return static_cast<double>(inside) >= kMostInside * static_cast<double>(window_);
  }
  bool is_away(std::size_t i) const { return distance(i) > kRadius_m || rise(i) > kHeight_m; }

 private:
  void find_middle(double window_s) {
    std::vector<double> latitudes, longitudes, heights;
    for (std::size_t i = 0; i < std::min(size(), kMostInWindow); ++i) {
      if (seconds(0, i) > window_s) break;
      latitudes.push_back(at(i).place.latitude_deg);
      longitudes.push_back(unwrapped(at(i).place.longitude_deg, at(0).place.longitude_deg));
      if (const auto height = any_height(at(i))) heights.push_back(*height);
    }
    middle_ = {median(latitudes), median(longitudes)};
    if (!heights.empty()) height_ = median(heights);
    window_ = latitudes.size();
  }

  const std::vector<Fix>& fixes_;
  bool is_reversed_;
  std::size_t window_ = 0;
  geo::Place middle_;
  std::optional<double> height_;
};

/// Returns where the way begins for good, or the number of fixes if it does not.
std::size_t first_away(const FromEnd& fixes) {
  std::optional<std::size_t> run;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    if (!fixes.is_away(i)) {
      run.reset();
      continue;
    }
    if (!run) run = i;
    if (i - *run + 1 >= kFixesAway && fixes.seconds(*run, i) >= kAway_s) return *run;
  }
  return run.value_or(fixes.size());
}

/// Returns how many fixes stand still around the middle.
std::size_t standing_around(const FromEnd& fixes) {
  if (!fixes.begins_inside()) return 0;
  std::size_t first = first_away(fixes);
  if (first == fixes.size()) return 0;
  // The way to the rim of the circle belongs to the flight.
  const auto leaves = [&](std::size_t i) {
    const double least_m = kCreep_mps * fixes.seconds(i - 1, i);
    return fixes.distance(i) > fixes.distance(i - 1) + least_m ||
           fixes.rise(i) > fixes.rise(i - 1) + least_m;
  };
  while (first > 0 && leaves(first)) --first;
  if (first == 0) return 0;
  // What moves steadily from the beginning does not stand, however near it is yet.
  const double least_m = kCreep_mps * fixes.seconds(0, first);
  const double rise_m =
      std::abs(any_height(fixes.at(first)).value_or(0.0) - any_height(fixes.at(0)).value_or(0.0));
  const double way_m = distance_m(fixes.at(0).place, fixes.at(first).place);
  return std::max(way_m, rise_m) > std::max(least_m, kWander_m) ? 0 : first;
}

/// Returns how many fixes stand still at an end. Receivers need a while to find their place, and
/// loggers may be switched on just before the take-off, so two middles are tried.
std::size_t standing_from(const std::vector<Fix>& fixes, bool is_reversed) {
  return std::max(standing_around(FromEnd(fixes, is_reversed, kShortWindow_s)),
                  standing_around(FromEnd(fixes, is_reversed, kLongWindow_s)));
}

bool rests(const FromEnd& fixes, std::size_t count) {
  if (count < kFewestAtRest) return false;
  const double time_s = fixes.seconds(0, count - 1);
  const double way_m = distance_m(fixes.at(0).place, fixes.at(count - 1).place);
  return time_s >= kRest_s || (time_s >= kShortRest_s && way_m < kCreep_mps * time_s);
}

}  // namespace

Standing standing_ends(const std::vector<Fix>& fixes) {
  if (fixes.size() < 2) return {};
  const std::size_t start = standing_from(fixes, false), end = standing_from(fixes, true);
  if (start + end >= fixes.size()) return {};
  return {start, end, rests(FromEnd(fixes, false, 0.0), start),
          rests(FromEnd(fixes, true, 0.0), end)};
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace aerostat::track
