#include "film/keys.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/smooth_step.hpp"
#include "scene/field_rule.hpp"
#include "scene/film_semantics.hpp"
#include "scene/sun_position.hpp"

namespace aerostat::film {
namespace {

constexpr double kDay_s = 86400.0;

/// Two keys, and the share of the way between them. They are the same before the first key and
/// after the last one.
struct Place {
  const scene::KeyValue* from;
  const scene::KeyValue* to;
  double share;
};

Place place_at(const scene::KeyTrack& track, double time_s) {
  const auto next =
      std::upper_bound(track.keys.begin(), track.keys.end(), time_s,
                       [](double time, const scene::Key& key) { return time < key.time_s; });
  if (next == track.keys.begin()) return {&next->is, &next->is, 0.0};
  const scene::Key& last = *std::prev(next);
  if (next == track.keys.end()) return {&last.is, &last.is, 0.0};
  const double t = (time_s - last.time_s) / (next->time_s - last.time_s);
  return {&last.is, &next->is, eased(track.ease, t)};
}

/// Returns an angle that stands for the same direction and lies in a range.
double within(double angle_deg, double least, double most) {
  while (angle_deg > most) angle_deg -= 360.0;
  while (angle_deg < least) angle_deg += 360.0;
  return angle_deg;
}

/// Returns the seconds from midnight in universal time. The scene's check has read the text before.
double day_seconds(const std::string& time) {
  const std::string day = "2000-01-01", midnight = "00:00";
  const auto at = scene::detail::days_from_2000(day, time);
  const auto zero = scene::detail::days_from_2000(day, midnight);
  if (!at || !zero) throw Error(ErrorKind::bad_data, "a key gives no time of day: " + time);
  return kDay_s * (*at - *zero);
}

std::string time_between(const Place& place) {
  const double from = day_seconds(place.from->text), to = day_seconds(place.to->text);
  const double seconds = std::fmod(std::lerp(from, to, place.share) + kDay_s, kDay_s);
  const auto thousandths = std::llround(1000.0 * seconds) % static_cast<long long>(1000.0 * kDay_s);
  return fmt::format("{:02}:{:02}:{:02}.{:03}Z", thousandths / 3600000, thousandths / 60000 % 60,
                     thousandths / 1000 % 60, thousandths % 1000);
}

double number_between(const Place& place, std::size_t index) {
  return std::lerp(place.from->numbers[index], place.to->numbers[index], place.share);
}

/// Returns the value of a track at a time as the text of JSON.
std::string text_at(const scene::KeyTrack& track, double time_s) {
  const Place place = place_at(track, time_s);
  switch (scene::key_kind(track.value).value_or(scene::KeyKind::word)) {
    case scene::KeyKind::number:
      return fmt::format("{}", number_between(place, 0));
    case scene::KeyKind::integer:
      return fmt::format("{}", std::llround(number_between(place, 0)));
    case scene::KeyKind::angle: {
      const scene::FieldRule rule = scene::field_rule(track.value);
      const double angle = angle_between(place.from->numbers[0], place.to->numbers[0], place.share);
      return fmt::format("{}", within(angle, rule.minimum, rule.maximum));
    }
    case scene::KeyKind::numbers: {
      std::vector<double> numbers;
      for (std::size_t i = 0; i < place.from->numbers.size(); ++i) {
        numbers.push_back(number_between(place, i));
      }
      return fmt::format("[{}]", fmt::join(numbers, ", "));
    }
    case scene::KeyKind::time:
      return time_between(place);
    case scene::KeyKind::word:
      break;
  }
  return place.from->text;
}

}  // namespace

double eased(scene::Easing ease, double t) {
  switch (ease) {
    case scene::Easing::linear:
      return t;
    case scene::Easing::smooth:
      return smooth_unit_step(t);
    case scene::Easing::hold:
      break;
  }
  return 0.0;
}

double angle_between(double a_deg, double b_deg, double share) {
  return a_deg + share * std::remainder(b_deg - a_deg, 360.0);
}

std::vector<scene::Override> changes_at(const std::vector<scene::KeyTrack>& tracks, double time_s) {
  std::vector<scene::Override> changes;
  for (const scene::KeyTrack& track : tracks) {
    changes.push_back({track.value, text_at(track, time_s)});
  }
  return changes;
}

std::optional<double> element_at(const std::vector<scene::KeyTrack>& tracks,
                                 const std::string& array, int index, double time_s) {
  const std::string element = fmt::format("{}/{}", array, index);
  std::optional<double> found;
  // The last track wins, as in changes_at.
  for (const scene::KeyTrack& track : tracks) {
    if (track.value == element) found = number_between(place_at(track, time_s), 0);
    if (track.value == array) {
      found = number_between(place_at(track, time_s), static_cast<std::size_t>(index));
    }
  }
  return found;
}

bool is_moved(const std::vector<scene::KeyTrack>& tracks, const std::string& pointer) {
  const auto leads_to = [](const std::string& part, const std::string& whole) {
    return part.starts_with(whole) && (part.size() == whole.size() || part[whole.size()] == '/');
  };
  return std::any_of(tracks.begin(), tracks.end(), [&](const scene::KeyTrack& track) {
    return leads_to(track.value, pointer) || leads_to(pointer, track.value);
  });
}

}  // namespace aerostat::film
