#include "track/text.hpp"

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <system_error>

#include <fmt/format.h>

namespace aerostat::track {

namespace {

constexpr std::size_t kLongestText = 200;
constexpr double kDay_s = 86400.0;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Returns the number of bytes of the UTF-8 character at the beginning of `text`, or 0 if there is
/// none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return 1;
  const std::size_t length = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
  if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < length) return 0;
  std::uint32_t code = byte(0) & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3fu);
  }
  constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  return code < kLeast[length] || code > 0x10ffff || is_surrogate ? 0 : length;
}

/// Takes parts off the front of a text.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  bool is_done() const { return rest_.empty(); }

  /// Takes a number of exactly `count` digits.
  std::optional<int> digits(std::size_t count) {
    const auto number = digits_of(rest_.substr(0, count));
    if (!number || rest_.size() < count) return std::nullopt;
    rest_.remove_prefix(count);
    return number;
  }

  /// Takes one of several characters, or returns 0.
  char any_of(std::string_view characters) {
    if (rest_.empty() || characters.find(rest_[0]) == std::string_view::npos) return 0;
    const char found = rest_[0];
    rest_.remove_prefix(1);
    return found;
  }

  /// Takes all digits behind a decimal point as a fraction.
  double fraction() {
    double value = 0.0;
    for (double place = 0.1; !rest_.empty() && is_digit(rest_[0]); place *= 0.1) {
      value += place * (rest_[0] - '0');
      rest_.remove_prefix(1);
    }
    return value;
  }

 private:
  std::string_view rest_;
};

std::optional<double> scan_date(Scanner& scanner) {
  const auto year = scanner.digits(4);
  if (!year || !scanner.any_of("-")) return std::nullopt;
  const auto month = scanner.digits(2);
  if (!month || !scanner.any_of("-")) return std::nullopt;
  const auto day = scanner.digits(2);
  const auto days = day ? days_of(*year, *month, *day) : std::nullopt;
  if (!days) return std::nullopt;
  return *days * kDay_s;
}

/// Reads hours and minutes, and the seconds if there are any.
std::optional<double> scan_clock(Scanner& scanner) {
  const auto hour = scanner.digits(2);
  if (!hour || *hour > 24 || !scanner.any_of(":")) return std::nullopt;
  const auto minute = scanner.digits(2);
  if (!minute || *minute > 59) return std::nullopt;
  double seconds = *hour * 3600.0 + *minute * 60.0;
  if (!scanner.any_of(":")) return seconds;
  const auto second = scanner.digits(2);
  if (!second || *second > 60) return std::nullopt;  // 60: a leap second
  seconds += *second;
  if (scanner.any_of(".,")) seconds += scanner.fraction();
  return seconds <= kDay_s + 1.0 ? std::optional(seconds) : std::nullopt;
}

/// Reads an offset such as +02:00, +0200 or +02, whose sign is taken already.
std::optional<double> scan_offset(Scanner& scanner) {
  const auto hours = scanner.digits(2);
  if (!hours || *hours > 24) return std::nullopt;
  double offset = *hours * 3600.0;
  scanner.any_of(":");
  if (scanner.is_done()) return offset;
  const auto minutes = scanner.digits(2);
  if (!minutes || *minutes > 59) return std::nullopt;
  return offset + *minutes * 60.0;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n\f\v";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::optional<double> number_of(std::string_view text) {
  text = trimmed(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<int> digits_of(std::string_view text) {
  if (text.empty() || text.size() > 9) return std::nullopt;
  int value = 0;
  for (const char c : text) {
    if (!is_digit(c)) return std::nullopt;
    value = value * 10 + (c - '0');
  }
  return value;
}

std::optional<int> days_of(int year, int month, int day) {
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return std::nullopt;
  return std::chrono::sys_days(date).time_since_epoch().count();
}

std::optional<ReadTime> time_of(std::string_view text) {
  Scanner scanner(trimmed(text));
  const auto date = scan_date(scanner);
  if (!date || !scanner.any_of("Tt ")) return std::nullopt;
  const auto clock = scan_clock(scanner);
  if (!clock) return std::nullopt;
  ReadTime time{*date + *clock, true};
  const char zone = scanner.any_of("Zz+-");
  if (zone == '+' || zone == '-') {
    const auto offset = scan_offset(scanner);
    if (!offset) return std::nullopt;
    time.time_s -= zone == '+' ? *offset : -*offset;
  }
  time.has_zone = zone != 0;
  return scanner.is_done() ? std::optional(time) : std::nullopt;
}

std::string utc_text(double time_s) {
  const double days = std::floor(time_s / kDay_s);
  if (!(std::abs(days) < 1e6)) return "an unknown time";
  const std::chrono::year_month_day date{
      std::chrono::sys_days(std::chrono::days(static_cast<int>(days)))};
  return fmt::format("{:04}-{:02}-{:02} {} UTC", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock_text(time_s));
}

std::string clock_text(double time_s) {
  const double in_day = time_s - kDay_s * std::floor(time_s / kDay_s);
  const int seconds = std::isfinite(in_day) ? static_cast<int>(in_day) : 0;
  return fmt::format("{:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

std::string duration_text(double seconds) {
  const double whole = std::round(seconds);
  if (!(whole < 1e9)) return "a very long time";
  const int time_s = static_cast<int>(whole);
  if (time_s < 60) return fmt::format("{} s", time_s);
  if (time_s < 3600) return fmt::format("{} min {} s", time_s / 60, time_s % 60);
  return fmt::format("{} h {} min", time_s / 3600, time_s / 60 % 60);
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string clean_text(std::string_view text) {
  text = trimmed(text);
  const bool is_whole = is_utf8(text);
  std::string clean;
  while (!text.empty() && clean.size() < kLongestText) {
    const auto byte = static_cast<unsigned char>(text[0]);
    const std::size_t length = is_whole ? utf8_length(text) : 1;
    if (byte < 0x20 || byte == 0x7f) {
      clean += ' ';
    } else if (byte >= 0x80 && !is_whole) {
      clean += static_cast<char>(0xc0 | byte >> 6);
      clean += static_cast<char>(0x80 | (byte & 0x3f));
    } else {
      clean += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return clean;
}

std::string counted(std::size_t count, const char* one, const char* many) {
  const std::string digits = std::to_string(count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text + ' ' + (count == 1 ? one : many);
}

}  // namespace aerostat::track
