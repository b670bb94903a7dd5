#include "scene/expected.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace aerostat::scene::detail {

namespace {

std::string range_of(const Json& rule) {
  const bool above = rule.contains("exclusiveMinimum");
  const bool from = rule.contains("minimum");
  const bool to = rule.contains("maximum");
  std::string text;
  if (above) text = " above " + rule["exclusiveMinimum"].dump();
  if (from) text = " from " + rule["minimum"].dump();
  if (to) text += (above || from ? " to " : " up to ") + rule["maximum"].dump();
  return text;
}

std::string array_expected(const Json& rule) {
  const std::size_t least = rule.value("minItems", std::size_t{0});
  const std::size_t most = rule.value("maxItems", least);
  const std::string count =
      least == most ? std::to_string(least) : fmt::format("{} to {}", least, most);
  const Json& item = rule["items"];
  const std::string type = item.value("type", "object");  // a "$ref" leads to the rule of an object
  if (type == "number") return fmt::format("an array of {} numbers{}", count, range_of(item));
  const char* const what = type == "array" ? "colours [red, green, blue]" : "objects";
  return fmt::format("an array of {} {}", count, what);
}

std::vector<std::string> keys_of(const Json& rule) {
  std::vector<std::string> keys;
  for (const auto& [key, unused] : rule["properties"].items()) keys.push_back(key);
  return keys;
}

/// Returns the number of edits (insert, delete, change, swap of neighbours) that turn one word
/// into the other.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, last(b.size() + 1), now(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        now[j] = std::min(now[j], before[j - 2] + 1);
      }
    }
    before = last;
    std::swap(last, now);
  }
  return last[b.size()];
}

void tell_by_object(Pointer pointer, const Json& value, const Json& rule, Faults& faults) {
  const std::vector<std::string> known = keys_of(rule);
  pointer.emplace_back();
  for (const auto& [key, unused] : value.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string near = nearest_word(key, known);
    const std::string hint = near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near);
    pointer.back() = key;
    faults.add(pointer, "an unknown key", fmt::format("one of {}{}", fmt::join(known, ", "), hint));
  }
  for (const Json& key : rule.value("required", Json::array())) {
    pointer.back() = key.get<std::string>();
    if (value.contains(pointer.back())) continue;
    faults.add(pointer, "nothing", expected_by(rule["properties"][pointer.back()]));
  }
}

}  // namespace

const Json& resolve_rule(const Json& rule, const Json& schema, std::string_view type) {
  if (rule.contains("$ref")) {
    const std::string path = rule["$ref"].get<std::string>().substr(1);
    return schema.at(Json::json_pointer(path));
  }
  if (rule.contains("anyOf")) {
    for (const Json& alternative : rule["anyOf"]) {
      if (alternative["type"] == type) return alternative;
    }
  }
  return rule;
}

const Json& child_rule(const Json& rule, const std::string& token) {
  return rule.contains("items") ? rule["items"] : rule.at("properties").at(token);
}

std::string expected_by(const Json& rule) {
  if (rule.contains("anyOf")) {
    std::vector<std::string> parts;
    for (const Json& alternative : rule["anyOf"]) parts.push_back(expected_by(alternative));
    return fmt::format("{}", fmt::join(parts, ", or "));
  }
  if (rule.contains("enum")) {
    std::vector<std::string> words;
    for (const Json& word : rule["enum"]) words.push_back(word.dump());
    return words.size() == 1 ? words[0] : fmt::format("one of {}", fmt::join(words, ", "));
  }
  const std::string type = rule.value("type", "");
  if (type == "integer") return "an integer" + range_of(rule);
  if (type == "number") return "a number" + range_of(rule);
  if (type == "boolean") return "true or false";
  if (type == "string") return "a string";
  return type == "array" ? array_expected(rule) : "an object";
}

std::string nearest_word(const std::string& text, const std::vector<std::string>& words) {
  if (text.size() > 64) return "";
  std::string best;
  std::size_t best_cost = std::max<std::size_t>(2, text.size() / 3) + 1;
  const auto cost = [&text, &best_cost](const std::string& word) {
    const bool abbreviates = text.size() >= 3 && word.compare(0, text.size(), text) == 0;
    if (abbreviates) return std::size_t{1};
    // A difference in length takes as many edits, which is too many for most words.
    const auto [shorter, longer] = std::minmax({text.size(), word.size()});
    return longer - shorter >= best_cost ? longer - shorter : edit_distance(text, word);
  };
  for (const std::string& word : words) {
    const std::size_t word_cost = cost(word);
    if (word_cost >= best_cost || word_cost >= word.size()) continue;
    best = word;
    best_cost = word_cost;
  }
  return best;
}

bool tell_by_rule(const Pointer& pointer, const Json& value, const Json& rule, Faults& faults) {
  const std::size_t before = faults.count();
  if (value.is_object() && rule.value("type", "") == "object") {
    tell_by_object(pointer, value, rule, faults);
    return faults.count() > before;
  }
  std::string expected = expected_by(rule);
  if (rule.contains("enum") && value.is_string()) {
    std::vector<std::string> words;
    for (const Json& word : rule["enum"]) {
      if (word.is_string()) words.push_back(word.get<std::string>());
    }
    const std::string near = nearest_word(value.get<std::string>(), words);
    if (!near.empty()) expected += fmt::format("; did you mean \"{}\"?", near);
  }
  faults.add(pointer, describe(value), expected);
  return true;
}

}  // namespace aerostat::scene::detail
