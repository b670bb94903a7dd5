#include "track/times.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

#include "core/error.hpp"
#include "track/text.hpp"

namespace aerostat::track {

namespace {

constexpr double kDay_s = 86400.0;
constexpr double kEarliest_s = 3657 * kDay_s;  // 1980-01-06, when the time of GPS begins
constexpr double kLatest_s = 47482 * kDay_s;   // 2100-01-01
constexpr double kLongestInterval_s = kDay_s;

template <class Action>
void for_each_fix(Track& track, Action action) {
  for (Segment& segment : track.segments) {
    for (Fix& fix : segment) action(fix);
  }
}

template <class Condition>
std::size_t count_if(const Track& track, Condition condition) {
  std::size_t count = 0;
  for (const Segment& segment : track.segments) {
    count += static_cast<std::size_t>(std::count_if(segment.begin(), segment.end(), condition));
  }
  return count;
}

template <class Condition>
void remove_if(Track& track, Condition condition) {
  for (Segment& segment : track.segments) {
    segment.erase(std::remove_if(segment.begin(), segment.end(), condition), segment.end());
  }
  const auto is_empty = [](const Segment& segment) { return segment.empty(); };
  track.segments.erase(std::remove_if(track.segments.begin(), track.segments.end(), is_empty),
                       track.segments.end());
}

bool has_time(const Fix& fix) {
  return fix.time_s.has_value();
}

bool has_no_time(const Fix& fix) {
  return !fix.time_s.has_value();
}

void drop_times(Track& track, const std::string& note) {
  for_each_fix(track, [](Fix& fix) { fix.time_s.reset(); });
  track.clock = Clock::none;
  track.notes.push_back(note);
}

/// Takes away times that no clock of a satellite receiver can show.
void drop_implausible(Track& track) {
  if (track.clock != Clock::utc) return;
  const std::size_t timed = count_if(track, has_time);
  const auto is_wrong = [](const Fix& fix) {
    return fix.time_s && (*fix.time_s < kEarliest_s || *fix.time_s > kLatest_s);
  };
  const std::size_t wrong = count_if(track, is_wrong);
  if (wrong == 0) return;
  double example_s = 0.0;
  for_each_fix(track, [&](Fix& fix) {
    if (!is_wrong(fix)) return;
    example_s = *fix.time_s;
    fix.time_s.reset();
  });
  const std::string found =
      fmt::format("such as {}, before 1980 or after 2100", utc_text(example_s));
  if (wrong * 2 > timed) {
    drop_times(track, fmt::format("The times are wrong ({}), so none of them is used.", found));
  } else {
    track.notes.push_back(
        fmt::format("{} wrong ({}).", counted(wrong, "time is", "times are"), found));
  }
}

/// Leaves out the fixes without a time if most fixes have one, and all times if most have none.
void settle_mixed(Track& track) {
  const std::size_t timed = count_if(track, has_time);
  const std::size_t untimed = count_if(track, has_no_time);
  if (timed == 0) track.clock = Clock::none;
  if (timed == 0 || untimed == 0) return;
  if (timed < untimed) {
    drop_times(track, fmt::format("Only {} of {} a time, so no time is used.", timed,
                                  counted(timed + untimed, "fix has", "fixes have")));
    return;
  }
  remove_if(track, has_no_time);
  track.notes.push_back(
      fmt::format("{} without a time left out.", counted(untimed, "fix was", "fixes were")));
}

void sort_segments(Track& track) {
  const auto begins_before = [](const Segment& a, const Segment& b) {
    return *a.front().time_s < *b.front().time_s;
  };
  if (std::is_sorted(track.segments.begin(), track.segments.end(), begins_before)) return;
  std::stable_sort(track.segments.begin(), track.segments.end(), begins_before);
  track.notes.emplace_back("The segments were put into the order of their times.");
}

/// Leaves out fixes whose time falls back or stands still.
void drop_backwards(Track& track) {
  std::vector<double> times_s;
  for_each_fix(track, [&](Fix& fix) { times_s.push_back(*fix.time_s); });
  const std::vector<bool> rises = rising_part(times_s);
  const auto kept = static_cast<std::size_t>(std::count(rises.begin(), rises.end(), true));
  if (kept * 2 < times_s.size()) {
    drop_times(track, "The times run backwards, so none of them is used.");
    return;
  }
  std::size_t index = 0, equal = 0;
  double last_s = -1e300;
  for_each_fix(track, [&](Fix& fix) {
    const double time_s = *fix.time_s;
    if (!rises[index++]) {
      fix.time_s.reset();
    } else if (time_s == last_s) {
      fix.time_s.reset();
      ++equal;
    } else {
      last_s = time_s;
    }
  });
  remove_if(track, has_no_time);
  const std::size_t back = times_s.size() - kept;
  if (back > 0) {
    track.notes.push_back(fmt::format("{} left out because the clock ran backwards or jumped.",
                                      counted(back, "fix was", "fixes were")));
  }
  if (equal > 0) {
    track.notes.push_back(fmt::format("{} left out because the one before has the same time.",
                                      counted(equal, "fix was", "fixes were")));
  }
}

void give_times(Track& track, const ReadOptions& options) {
  double time_s = *options.start_s;
  for_each_fix(track, [&](Fix& fix) {
    fix.time_s = time_s;
    time_s += *options.interval_s;
  });
  track.clock = Clock::utc;
  track.notes.push_back(fmt::format("The times were given: {}, and {} s from fix to fix.",
                                    utc_text(*options.start_s), *options.interval_s));
}

void check(const ReadOptions& options) {
  const auto is_time = [](double time_s) { return time_s >= kEarliest_s && time_s <= kLatest_s; };
  if (options.start_s && !is_time(*options.start_s)) {
    throw Error(ErrorKind::usage, "the start of the track is not between the years 1980 and 2100");
  }
  if (!options.interval_s) return;
  if (!(*options.interval_s > 0.0 && *options.interval_s <= kLongestInterval_s)) {
    throw Error(ErrorKind::usage,
                fmt::format("the interval of the track is {} s; expected more than 0 and at most "
                            "{} s",
                            *options.interval_s, kLongestInterval_s));
  }
  if (!options.start_s) {
    throw Error(ErrorKind::usage, "the interval of the track needs its start as well");
  }
}

}  // namespace

std::vector<bool> rising_part(const std::vector<double>& times_s) {
  if (std::is_sorted(times_s.begin(), times_s.end())) {
    return std::vector<bool>(times_s.size(), true);
  }
  // tails[n] is the element with the smallest time that ends a rising part of n + 1 elements.
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> tails, before(times_s.size(), kNone);
  for (std::uint32_t i = 0; i < times_s.size(); ++i) {
    const auto place =
        std::upper_bound(tails.begin(), tails.end(), times_s[i],
                         [&](double time_s, std::uint32_t tail) { return time_s < times_s[tail]; });
    if (place != tails.begin()) before[i] = *(place - 1);
    if (place == tails.end()) {
      tails.push_back(i);
    } else {
      *place = i;
    }
  }
  std::vector<bool> rises(times_s.size(), false);
  for (std::uint32_t i = tails.back(); i != kNone; i = before[i]) rises[i] = true;
  return rises;
}

void settle_times(Track& track, const ReadOptions& options) {
  check(options);
  drop_implausible(track);
  settle_mixed(track);
  if (track.clock != Clock::none) {
    sort_segments(track);
    drop_backwards(track);
  }
  if (track.clock == Clock::of_day && options.start_s) {
    const double day_s = kDay_s * std::floor(*options.start_s / kDay_s);
    for_each_fix(track, [&](Fix& fix) { *fix.time_s += day_s; });
    track.clock = Clock::utc;
    track.notes.emplace_back("The date was given.");
  }
  if (track.clock != Clock::none) {
    if (options.interval_s) {
      track.notes.emplace_back("The given interval was not needed, because the track has times.");
    }
  } else if (options.start_s && options.interval_s) {
    give_times(track, options);
  } else {
    track.notes.emplace_back(
        "The track has no times. Its start and the interval between its fixes can be given.");
  }
}

}  // namespace aerostat::track
