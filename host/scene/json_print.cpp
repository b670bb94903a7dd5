#include "scene/json_print.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace aerostat::scene::detail {

namespace {

/// Returns the shortest text of a number. The text has no exponent for sizes from 1e-5 to 1e15.
std::string number_text(double value) {
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  const bool readable = size >= 1e-5 && size < 1e15;
  char buffer[64];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value,
                    readable ? std::chars_format::fixed : std::chars_format::scientific);
  return {buffer, end.ptr};
}

bool is_plain(const OrderedJson& value) {
  return !value.is_structured();
}

void print(const OrderedJson& value, const std::string& indent, std::string& out) {
  if (value.is_number_float()) {
    out += number_text(value.get<double>());
    return;
  }
  if (is_plain(value) || value.empty()) {
    out += value.dump();
    return;
  }
  const bool in_line = value.is_array() && std::all_of(value.begin(), value.end(), is_plain);
  const std::string inner = indent + "  ";
  out += value.is_array() ? '[' : '{';
  std::string_view separator = in_line ? "" : "\n";
  for (const auto& [key, child] : value.items()) {
    out += separator;
    if (!in_line) out += inner;
    if (value.is_object()) out += OrderedJson(key).dump() + ": ";
    print(child, inner, out);
    separator = in_line ? ", " : ",\n";
  }
  if (!in_line) out += '\n' + indent;
  out += value.is_array() ? ']' : '}';
}

}  // namespace

double shortest(float value) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
  double result = 0.0;
  std::from_chars(buffer, end.ptr, result);
  return result == 0.0 ? 0.0 : result;
}

std::string print_json(const OrderedJson& value) {
  std::string text;
  print(value, "", text);
  return text + '\n';
}

}  // namespace aerostat::scene::detail
