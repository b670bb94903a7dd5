#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "scene/json_text.hpp"

namespace aerostat::asset {

using scene::detail::Json;

/// A value of a JSON document and its pointer, or a value that is missing. Every function throws
/// Error{bad_data} with the pointer if the value has another type than the function returns.
class JsonValue {
 public:
  explicit JsonValue(const Json& document) : json_(&document) {}

  bool exists() const { return json_ != nullptr; }
  const std::string& pointer() const { return pointer_; }

  /// Returns a member of an object. A missing object has no members.
  JsonValue operator[](const std::string& key) const;

  /// Returns the number of elements of an array. A missing array has none.
  std::size_t size() const;
  /// Returns an element of an array, which must have it.
  JsonValue at(std::size_t i) const;
  /// Returns whether an object has members or an array has elements.
  bool is_filled() const { return exists() && !json_->empty(); }
  /// Returns the names of the members of an object.
  std::vector<std::string> keys() const;

  double number(double otherwise) const;
  /// Returns a number that must lie between two others.
  double number(double otherwise, double least, double most) const;
  bool flag(bool otherwise) const;
  std::string text() const;  // a missing text is empty
  /// Returns an integer that is not negative and less than 2^53.
  std::uint64_t whole(std::uint64_t otherwise) const;
  std::uint64_t whole() const;  // which must exist
  /// Returns an integer below `count`, the number of the `what` that there are.
  std::size_t index(std::size_t count, const char* what) const;

  /// Returns the numbers of an array of N.
  template <std::size_t N>
  std::array<double, N> numbers(const std::array<double, N>& otherwise) const {
    if (!exists()) return otherwise;
    std::array<double, N> result{};
    if (!json_->is_array() || json_->size() != N) fail(std::to_string(N) + " numbers");
    for (std::size_t i = 0; i < N; ++i) result[i] = at(i).number(0.0);
    return result;
  }

  /// Throws Error{bad_data} that says what was expected in place of this value.
  [[noreturn]] void fail(const std::string& expected) const;
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

 private:
  JsonValue(const Json* json, std::string pointer) : json_(json), pointer_(std::move(pointer)) {}

  const Json* json_ = nullptr;
  std::string pointer_;
};

}  // namespace aerostat::asset
