#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "track/clean.hpp"
#include "track/distance.hpp"
#include "track/flight.hpp"
#include "track/heights.hpp"
#include "track/smooth.hpp"
#include "track/standing.hpp"
#include "track/text.hpp"

namespace aerostat::track {

namespace {

constexpr double kGap_s = 30.0;
constexpr double kSegmentGap_s = 10.0;          // between segments less is a gap
constexpr double kSlowGap = 3.0;                // and of slow loggers, so many times their interval
constexpr double kRestWindow_s = 60.0;          // the ground is compared with so long a rest
constexpr std::size_t kFixesAtEnd = 3;          // or with so many fixes without a rest
constexpr double kGroundSmoothing_s = 60.0;     // of assumed heights over the ground
constexpr double kAir_m = 40.0, kAir_s = 60.0;  // so high and so long is in the air
constexpr double kManyClamped = 0.1;            // a share of clamped fixes that is worth a note

using Heights = std::vector<std::optional<double>>;

Heights heights_of(const std::vector<Fix>& fixes, std::optional<double> Fix::*height) {
  Heights heights;
  heights.reserve(fixes.size());
  for (const Fix& fix : fixes) heights.push_back(fix.*height);
  return heights;
}

std::size_t known(const Heights& heights) {
  return static_cast<std::size_t>(
      std::count_if(heights.begin(), heights.end(), [](const auto& h) { return h.has_value(); }));
}

/// Returns the heights with those that are missing interpolated by time, or copied at the ends.
std::vector<double> filled(const std::vector<double>& times, const Heights& heights) {
  std::vector<double> result(heights.size(), 0.0);
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!heights[i]) continue;
    result[i] = *heights[i];
    for (std::size_t k = last ? *last + 1 : 0; k < i; ++k) {
      const double share = last ? (times[k] - times[*last]) / (times[i] - times[*last]) : 1.0;
      result[k] = last ? result[*last] + share * (result[i] - result[*last]) : result[i];
    }
    last = i;
  }
  for (std::size_t k = last ? *last + 1 : heights.size(); k < heights.size(); ++k) {
    result[k] = result[*last];
  }
  return result;
}

}  // namespace

/// Makes a flight step by step.
class Fitting {
 public:
  Fitting(const Track& track, const Ground& ground, const FitOptions& options)
      : track_(track),
        options_(options),
        fixes_(all_fixes(track)),
        flight_({}, track.clock, ground, options.clearance_m) {
    if (fixes_.empty()) throw Error(ErrorKind::bad_data, "the track has no fix");
  }

  Flight run() {
    flight_.cut_start_s_ = track_.cut_start_s;
    flight_.cut_end_s_ = track_.cut_end_s;
    lay_out();
    find_standing();
    find_gaps();
    find_ground();
    choose_and_shift();
    clamp();
    find_air();
    return std::move(flight_);
  }

 private:
  bool is_timed() const { return track_.clock != Clock::none; }
  std::size_t count() const { return fixes_.size(); }

  void lay_out();
  void find_standing();
  void find_gaps();
  void find_ground();
  EndOffsets offsets(const Heights& heights) const;
  std::optional<double> offset(const Heights& heights, std::size_t first, std::size_t end) const;
  void choose_and_shift();
  void take(const Heights& heights, const HeightChoice& choice);
  void take_over_ground(const Heights& heights, double smoothing_s);
  void clamp();
  void find_air();

  const Track& track_;
  FitOptions options_;
  std::vector<Fix> fixes_;
  Heights ground_;
  Standing standing_;
  Flight flight_;
};

void Fitting::lay_out() {
  Course& course = flight_.course_;
  double way_m = 0.0;
  for (std::size_t i = 0; i < count(); ++i) {
    const geo::Place& place = fixes_[i].place;
    const geo::Place& last = fixes_[i == 0 ? 0 : i - 1].place;
    // A millimetre keeps the way rising where the place stays the same.
    way_m += i == 0 ? 0.0 : std::max(distance_m(last, place), 1e-3);
    course.times.push_back(is_timed() ? *fixes_[i].time_s : way_m);
    course.latitudes_deg.push_back(place.latitude_deg);
    const double near = i == 0 ? place.longitude_deg : course.longitudes_deg.back();
    course.longitudes_deg.push_back(unwrapped(place.longitude_deg, near));
  }
  if (!is_timed()) return;
  const double window_s = options_.smoothing_place_s;
  course.latitudes_deg = smoothed(course.times, course.latitudes_deg, window_s);
  course.longitudes_deg = smoothed(course.times, course.longitudes_deg, window_s);
  for (double& latitude : course.latitudes_deg) latitude = std::clamp(latitude, -90.0, 90.0);
}

void Fitting::find_standing() {
  if (is_timed()) standing_ = standing_ends(fixes_);
  flight_.takeoff_ = standing_.start;
  flight_.landing_ = count() - 1 - standing_.end;
  flight_.fit_.rests_at_start = standing_.rests_at_start;
  flight_.fit_.rests_at_end = standing_.rests_at_end;
}

void Fitting::find_gaps() {
  if (!is_timed()) return;
  const std::vector<double>& times = flight_.course_.times;
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < count(); ++i) steps_s.push_back(times[i] - times[i - 1]);
  const double longest_s = std::max(kGap_s, kSlowGap * median(steps_s));
  std::size_t i = 0;
  for (const Segment& segment : track_.segments) {
    for (std::size_t k = 0; k < segment.size(); ++k, ++i) {
      if (i == 0 || steps_s[i - 1] <= (k == 0 ? kSegmentGap_s : longest_s)) continue;
      flight_.gaps_.push_back(
          {times[i - 1], times[i], distance_m(fixes_[i - 1].place, fixes_[i].place)});
    }
  }
}

void Fitting::find_ground() {
  ground_.assign(count(), std::nullopt);
  if (!flight_.ground_) return;
  const Course& course = flight_.course_;
  for (std::size_t i = 0; i < count(); ++i) {
    ground_[i] = flight_.ground_({course.latitudes_deg[i], wrapped(course.longitudes_deg[i])});
  }
  const std::size_t unknown = count() - known(ground_);
  if (unknown == 0) return;
  flight_.fit_.notes.push_back(unknown == count() ? "The whole track lies outside of the ground."
                                                  : fmt::format("The ground is not known below {}.",
                                                                counted(unknown, "fix", "fixes")));
}

/// Returns the median height over the ground of some fixes.
std::optional<double> Fitting::offset(const Heights& heights, std::size_t first,
                                      std::size_t end) const {
  std::vector<double> offsets;
  for (std::size_t i = first; i < end; ++i) {
    if (heights[i] && ground_[i]) offsets.push_back(*heights[i] - *ground_[i]);
  }
  return offsets.empty() ? std::nullopt : std::optional(median(offsets));
}

EndOffsets Fitting::offsets(const Heights& heights) const {
  const std::vector<double>& times = flight_.course_.times;
  std::size_t first = 0, end = std::min(kFixesAtEnd, count());
  if (standing_.rests_at_start) {
    end = standing_.start;
    while (times[end - 1] - times[first] > kRestWindow_s) ++first;
  }
  std::size_t last_first = count() - std::min(kFixesAtEnd, count()), last_end = count();
  if (standing_.rests_at_end) {
    last_first = count() - standing_.end;
    while (times[last_end - 1] - times[last_first] > kRestWindow_s) --last_end;
  }
  return {offset(heights, first, end), offset(heights, last_first, last_end)};
}

void Fitting::choose_and_shift() {
  FitReport& fit = flight_.fit_;
  const Heights gnss = heights_of(fixes_, &Fix::gnss_m);
  const Heights pressure = heights_of(fixes_, &Fix::pressure_m);
  fit.gnss = offsets(gnss);
  fit.pressure = offsets(pressure);
  fit.has_ground = known(ground_) > 0;
  HeightEvidence evidence{track_.reference,
                          known(gnss) * 2 > count(),
                          known(pressure) * 2 > count(),
                          fit.has_ground,
                          fit.gnss,
                          fit.pressure};
  for (EndOffsets* ends : {&evidence.gnss, &evidence.pressure}) {
    if (!standing_.rests_at_start) ends->start_m.reset();
    if (!standing_.rests_at_end) ends->end_m.reset();
  }
  const HeightChoice choice = choose_heights(evidence);
  fit.source = choice.source;
  fit.shift_start_m = choice.shift_start_m;
  fit.shift_end_m = choice.shift_end_m;
  fit.notes.insert(fit.notes.end(), choice.notes.begin(), choice.notes.end());
  switch (choice.source) {
    case HeightSource::gnss:
    case HeightSource::gnss_shifted:
    case HeightSource::gnss_fitted:
      return take(gnss, choice);
    case HeightSource::pressure:
    case HeightSource::pressure_fitted:
      return take(pressure, choice);
    case HeightSource::over_ground:
      return take_over_ground(gnss, options_.smoothing_s);
    case HeightSource::assumed:
      return take_over_ground(Heights(count(), options_.height_without_m), kGroundSmoothing_s);
    case HeightSource::none:
      break;
  }
}

/// Takes heights over the sea. What is added goes over from the shift at the take-off to that at
/// the landing.
void Fitting::take(const Heights& heights, const HeightChoice& choice) {
  Course& course = flight_.course_;
  flight_.fit_.filled = count() - known(heights);
  flight_.fit_.smoothing_s = is_timed() ? options_.smoothing_s : 0.0;
  course.heights_m =
      smoothed(course.times, filled(course.times, heights), flight_.fit_.smoothing_s);
  const double begin = course.times[flight_.takeoff_], end = course.times[flight_.landing_];
  for (std::size_t i = 0; i < count(); ++i) {
    const double share =
        end > begin ? std::clamp((course.times[i] - begin) / (end - begin), 0.0, 1.0) : 0.0;
    course.heights_m[i] +=
        choice.shift_start_m + share * (choice.shift_end_m - choice.shift_start_m);
  }
}

/// Takes heights over the ground.
void Fitting::take_over_ground(const Heights& heights, double smoothing_s) {
  Course& course = flight_.course_;
  flight_.fit_.filled = count() - known(heights);
  flight_.fit_.smoothing_s = is_timed() ? smoothing_s : 0.0;
  const std::vector<double> over = filled(course.times, heights);
  std::vector<double> sums = filled(course.times, ground_);
  for (std::size_t i = 0; i < count(); ++i) sums[i] += over[i];
  course.heights_m = smoothed(course.times, sums, flight_.fit_.smoothing_s);
}

void Fitting::clamp() {
  FitReport& fit = flight_.fit_;
  std::vector<double>& heights_m = flight_.course_.heights_m;
  for (std::size_t i = 0; i < heights_m.size(); ++i) {
    const double least_m = ground_[i].value_or(-1e9) + options_.clearance_m;
    if (heights_m[i] >= least_m) continue;
    fit.clamped_most_m = std::max(fit.clamped_most_m, least_m - heights_m[i]);
    heights_m[i] = least_m;
    ++fit.clamped;
  }
  if (static_cast<double>(fit.clamped) > kManyClamped * static_cast<double>(count())) {
    fit.notes.emplace_back(
        "Many fixes lay below the ground. The heights or the ground may be wrong.");
  }
}

/// Finds where the flight is in the air for good, so that a drive before or after it does not
/// count. Without such a part the standing ends decide.
void Fitting::find_air() {
  const Course& course = flight_.course_;
  if (!is_timed() || course.heights_m.empty()) return;
  const auto over = [&](std::size_t i) {
    return ground_[i] ? course.heights_m[i] - *ground_[i] : kAir_m;
  };
  std::optional<std::size_t> first, last, run;
  for (std::size_t i = flight_.takeoff_; i <= flight_.landing_; ++i) {
    if (!ground_[i] || over(i) < kAir_m) {
      run.reset();
      continue;
    }
    if (!run) run = i;
    if (course.times[i] - course.times[*run] < kAir_s) continue;
    if (!first) first = run;
    last = i;
  }
  if (!first || !last) return;
  while (*first > flight_.takeoff_ && over(*first - 1) < over(*first)) --*first;
  while (*last < flight_.landing_ && over(*last + 1) < over(*last)) ++*last;
  flight_.takeoff_ = *first;
  flight_.landing_ = *last;
}

Flight fit_heights(const Track& track, const Ground& ground, const FitOptions& options) {
  return Fitting(track, ground, options).run();
}

}  // namespace aerostat::track
