#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

/// These functions parse JSON with limits, write JSON pointers and show values in messages.
namespace aerostat::scene::detail {

using Json = nlohmann::json;

inline constexpr std::size_t kMaxFileBytes = std::size_t{16} << 20;
inline constexpr std::size_t kMaxDepth = 64;        // levels of arrays and objects in each other
inline constexpr std::size_t kMaxValues = 100'000;  // values in one file

/// The unescaped reference tokens of a JSON pointer (RFC 6901).
using Pointer = std::vector<std::string>;

/// Returns a pointer as text, such as "/a/b". '~' and '/' are escaped, and control characters are
/// made visible. The text "/" stands for the whole document.
std::string to_string(const Pointer& pointer);

/// Throws a BadScene with one fault, whose message is "name: /pointer: found X, expected Y".
[[noreturn]] void fail(const std::string& name, const Pointer& pointer, const std::string& found,
                       const std::string& expected);

/// Returns a value as messages show it: short, on one line and without control characters.
std::string describe(const Json& value);

/// Returns whether a text is JSON, which may have comments. Numbers have a decimal point in every
/// locale of the process.
bool is_json(std::string_view text);

/// Parses JSON with comments. Throws Error{bad_data} with line and column on a syntax error.
/// Throws BadScene with the pointer on a key that an object has twice, a number beyond the range
/// of double, more than kMaxDepth levels or more than kMaxValues values.
Json parse_json(std::string_view text, const std::string& name);

/// What parse_json accepts of files other than scenes.
struct JsonRules {
  std::size_t most_depth = kMaxDepth;
  std::size_t most_values = kMaxValues;
  bool with_comments = true;
};
Json parse_json(std::string_view text, const std::string& name, const JsonRules& rules);

class Faults;

/// Parses JSON with comments. Keys that an object has twice are added to `faults` and their last
/// value counts. All other errors are thrown as by the function with a name.
Json parse_json(std::string_view text, Faults& faults, const JsonRules& rules = {});

}  // namespace aerostat::scene::detail
