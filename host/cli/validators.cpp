#include "cli/validators.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace aerostat::cli {

CLI::Validator in_range(std::int64_t least, std::int64_t most) {
  const auto validate = [least, most](std::string& text) {
    std::int64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    const bool is_number = error == std::errc() && rest == end;
    if (!is_number || value < least || value > most) {
      return fmt::format("Value {} not in range {} to {}", text, least, most);
    }
    text = std::to_string(value);
    return std::string();
  };
  return CLI::Validator(validate, "");
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto validate = [words](const std::string& text) {
    if (std::find(words.begin(), words.end(), text) != words.end()) return std::string();
    return fmt::format("{} not in {{{}}}", text, fmt::join(words, ","));
  };
  return CLI::Validator(validate, "");
}

}  // namespace aerostat::cli
