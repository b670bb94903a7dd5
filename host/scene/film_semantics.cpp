#include "scene/film_semantics.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "scene/faults.hpp"
#include "scene/field_rule.hpp"
#include "scene/sun_position.hpp"

namespace aerostat::scene {

namespace {

constexpr double kCircle_deg = 360.0;

/// Returns the rule of a value, or nothing if scenes have no such value.
std::optional<FieldRule> rule_at(const std::string& pointer) {
  try {
    return field_rule(pointer);
  } catch (const Error&) {
    return std::nullopt;
  }
}

bool is_fixed(std::string_view pointer) {
  for (const char* fixed : {"/film", "/image/width", "/image/height", "/version", "/quality",
                            "/camera/view", "/festival", "/biome/kind", "/biome/season", "/mood"}) {
    const std::string_view start(fixed);
    if (pointer == start || (pointer.starts_with(start) && pointer[start.size()] == '/')) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::optional<KeyKind> key_kind(const std::string& pointer) {
  if (pointer == "/sun/time") return KeyKind::time;
  const std::optional<FieldRule> rule = is_fixed(pointer) ? std::nullopt : rule_at(pointer);
  if (!rule) return std::nullopt;
  switch (rule->type) {
    case FieldType::integer:
      return KeyKind::integer;
    case FieldType::number: {
      const bool is_circle =
          pointer.ends_with("_deg") && rule->maximum - rule->minimum >= kCircle_deg;
      return is_circle ? KeyKind::angle : KeyKind::number;
    }
    case FieldType::word:
      return KeyKind::word;
    case FieldType::array: {
      // The rule of the first element tells an array of numbers from a list.
      const auto first = rule_at(pointer + "/0");
      const bool is_numbers = first && first->type == FieldType::number;
      return is_numbers ? std::optional(KeyKind::numbers) : std::nullopt;
    }
    default:
      return std::nullopt;
  }
}

namespace detail {

namespace {

std::string shown(const KeyValue& value) {
  if (value.is_array) return fmt::format("[{}]", fmt::join(value.numbers, ", "));
  return value.numbers.empty() ? describe(Json(value.text)) : fmt::format("{}", value.numbers[0]);
}

std::string range_of(const FieldRule& rule) {
  return fmt::format("from {} to {}", rule.minimum, rule.maximum);
}

bool is_within_range(const KeyValue& value, const FieldRule& rule) {
  return std::all_of(value.numbers.begin(), value.numbers.end(), [&rule](double number) {
    return number >= rule.minimum && number <= rule.maximum;
  });
}

bool is_one_number(const KeyValue& value) {
  return !value.is_array && value.numbers.size() == 1;
}

/// Returns what a key of this kind must give, or an empty text if `value` is that.
std::string expected_instead(const KeyValue& value, KeyKind kind, const FieldRule& rule) {
  switch (kind) {
    case KeyKind::number:
    case KeyKind::integer:
    case KeyKind::angle:
      if (is_one_number(value) && is_within_range(value, rule)) return {};
      return "a number " + range_of(rule);
    case KeyKind::numbers:
      if (value.is_array && static_cast<int>(value.numbers.size()) == rule.most_items &&
          is_within_range(value, rule)) {
        return {};
      }
      return fmt::format("an array of {} numbers {}", rule.most_items, range_of(rule));
    case KeyKind::word:
      if (std::find(rule.words.begin(), rule.words.end(), value.text) != rule.words.end()) {
        return {};
      }
      return fmt::format("one of {}", fmt::join(rule.words, ", "));
    case KeyKind::time:
      if (days_from_2000("2000-01-01", value.text)) return {};
      return "a time of day such as \"06:30\" or \"06:30:15Z\"";
  }
  return {};
}

void check_rising(const std::vector<double>& values, bool is_strict, const Pointer& list,
                  const char* key, const std::string& name) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (is_strict ? values[i] > values[i - 1] : values[i] >= values[i - 1]) continue;
    Pointer pointer = list;
    pointer.push_back(std::to_string(i));
    pointer.emplace_back(key);
    fail(name, pointer, fmt::format("{} after {}", values[i], values[i - 1]),
         "values that rise from one to the next");
  }
}

void check_track(const KeyTrack& track, Pointer pointer, const std::string& name) {
  const auto kind = key_kind(track.value);
  if (!kind) {
    pointer.emplace_back("value");
    fail(name, pointer, describe(Json(track.value)),
         "the JSON pointer of a number, an array of numbers or a word that can move, such as "
         "/sun/elevation_deg");
  }
  pointer.emplace_back("keys");
  std::vector<double> times;
  for (const Key& key : track.keys) times.push_back(key.time_s);
  if (times.empty()) fail(name, pointer, "no key", "one or more");
  check_rising(times, true, pointer, "time_s", name);
  const FieldRule rule = field_rule(track.value);
  for (std::size_t i = 0; i < track.keys.size(); ++i) {
    const std::string expected = expected_instead(track.keys[i].is, *kind, rule);
    if (expected.empty()) continue;
    pointer.push_back(std::to_string(i));
    pointer.emplace_back("is");
    fail(name, pointer, shown(track.keys[i].is), expected + ", as " + track.value + " has it");
  }
}

void check_keys(const Film& film, const std::string& name) {
  for (std::size_t i = 0; i < film.keys.size(); ++i) {
    check_track(film.keys[i], {"film", "keys", std::to_string(i)}, name);
    for (std::size_t j = 0; j < i; ++j) {
      if (film.keys[j].value != film.keys[i].value) continue;
      fail(name, {"film", "keys", std::to_string(i), "value"}, describe(Json(film.keys[i].value)),
           "each value once");
    }
  }
}

void check_path(const CameraMove& camera, const std::string& name) {
  const Pointer pointer{"film", "camera", "path"};
  if (camera.mode == CameraMode::path && camera.path.size() < 2) {
    fail(name, pointer, fmt::format("{} points", camera.path.size()), "two or more");
  }
  std::vector<double> times;
  for (const PathPoint& point : camera.path) times.push_back(point.time_s);
  const bool is_timed = std::any_of(times.begin(), times.end(), [](double t) { return t > 0.0; });
  if (is_timed) check_rising(times, true, pointer, "time_s", name);
}

}  // namespace

void check_film(const Film& film, const std::string& name) {
  check_keys(film, name);
  check_path(film.camera, name);
  std::vector<double> heights;
  for (const WindLayer& layer : film.wind) heights.push_back(layer.height_m);
  check_rising(heights, true, {"film", "wind"}, "height_m", name);
}

}  // namespace detail
}  // namespace aerostat::scene
