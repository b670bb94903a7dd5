#include "core/duration.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace aerostat {

std::optional<double> duration_s(const std::string& text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  const std::string unit(rest, end);
  const bool is_unit = unit.empty() || unit == "s" || unit == "m" || unit == "h";
  if (error != std::errc{} || !is_unit || !(number > 0.0) || !std::isfinite(number)) {
    return std::nullopt;
  }
  return number * (unit == "h" ? 3600.0 : unit == "m" ? 60.0 : 1.0);
}

}  // namespace aerostat
