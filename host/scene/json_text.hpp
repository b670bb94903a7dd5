#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

/// JSON as text: guarded parsing, pointers, and how values look in messages.
namespace aerostat::scene::detail {

using Json = nlohmann::json;

inline constexpr std::size_t kMaxFileBytes = std::size_t{16} << 20;
inline constexpr std::size_t kMaxDepth = 64;        // of arrays and objects in each other
inline constexpr std::size_t kMaxValues = 100'000;  // in one file

/// Reference tokens of a JSON pointer (RFC 6901), unescaped.
using Pointer = std::vector<std::string>;

/// "/a/b" with '~' and '/' escaped and control characters made visible; "/" alone means the whole.
std::string to_string(const Pointer& pointer);

/// Throws BadScene: "name: /pointer: found X, expected Y".
[[noreturn]] void fail(const std::string& name, const Pointer& pointer, const std::string& found,
                       const std::string& expected);

/// A value as a message shows it: short, on one line, without control characters.
std::string describe(const Json& value);

/// Parses JSON with comments. Throws Error{bad_data}, with line and column, on a syntax error; with
/// the pointer on a key that is there twice, a number beyond double, more than kMaxDepth levels or
/// kMaxValues values.
Json parse_json(std::string_view text, const std::string& name);

class Faults;

/// The same, but keys that are there twice are added to `faults`; of each the last counts.
Json parse_json(std::string_view text, Faults& faults);

}  // namespace aerostat::scene::detail
