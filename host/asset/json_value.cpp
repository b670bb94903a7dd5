#include "asset/json_value.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "asset/words.hpp"

namespace aerostat::asset {

JsonValue JsonValue::operator[](const std::string& key) const {
  const Json* found = nullptr;
  if (exists()) {
    if (!json_->is_object()) fail("an object");
    const auto member = json_->find(key);
    if (member != json_->end()) found = &*member;
  }
  const bool is_plain = std::all_of(
      key.begin(), key.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
  return {found, pointer_ + (is_plain ? "/" + key : scene::detail::to_string({key}))};
}

std::size_t JsonValue::size() const {
  if (!exists()) return 0;
  if (!json_->is_array()) fail("an array");
  return json_->size();
}

JsonValue JsonValue::at(std::size_t i) const {
  return {&(*json_)[i], fmt::format("{}/{}", pointer_, i)};
}

std::vector<std::string> JsonValue::keys() const {
  std::vector<std::string> keys;
  if (!exists()) return keys;
  if (!json_->is_object()) fail("an object");
  for (const auto& [key, value] : json_->items()) keys.push_back(key);
  return keys;
}

double JsonValue::number(double otherwise) const {
  if (!exists()) return otherwise;
  if (!json_->is_number()) fail("a number");
  return json_->get<double>();
}

double JsonValue::number(double otherwise, double least, double most) const {
  const double value = number(otherwise);
  if (!(value >= least && value <= most)) {
    fail(std::isinf(most) ? fmt::format("a number of at least {}", least)
                          : fmt::format("a number from {} to {}", least, most));
  }
  return value;
}

bool JsonValue::flag(bool otherwise) const {
  if (!exists()) return otherwise;
  if (!json_->is_boolean()) fail("true or false");
  return json_->get<bool>();
}

std::string JsonValue::text() const {
  if (!exists()) return {};
  if (!json_->is_string()) fail("a text");
  return json_->get<std::string>();
}

std::uint64_t JsonValue::whole(std::uint64_t otherwise) const {
  if (!exists()) return otherwise;
  constexpr double kMost = 9007199254740992.0;  // 2^53: all integers below are exact in double
  const double value = json_->is_number() ? json_->get<double>() : -1.0;
  if (!(value >= 0.0 && value < kMost) || value != std::floor(value)) {
    fail("an integer that is not negative");
  }
  return static_cast<std::uint64_t>(value);
}

std::uint64_t JsonValue::whole() const {
  if (!exists()) fail("an integer that is not negative");
  return whole(0);
}

std::size_t JsonValue::index(std::size_t count, const char* what) const {
  const std::uint64_t value = whole();
  if (value < count) return static_cast<std::size_t>(value);
  if (count == 0) fail(fmt::format("one of the {}, but there are none", what));
  fail(fmt::format("one of the {} {}, which are counted from 0", count, what));
}

void JsonValue::fail(const std::string& expected) const {
  fail(exists() ? scene::detail::describe(*json_) : "nothing", expected);
}

void JsonValue::fail(const std::string& found, const std::string& expected) const {
  refuse(
      fmt::format("{}: found {}, expected {}", pointer_.empty() ? "/" : pointer_, found, expected));
}

}  // namespace aerostat::asset
