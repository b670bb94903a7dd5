#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Numbers, times and letters in files of tracks. Nothing here depends on the locale.
namespace aerostat::track {

/// Returns `text` without white space at its ends.
std::string_view trimmed(std::string_view text);

/// Returns the finite number that the whole text is, apart from white space and a leading plus
/// sign.
std::optional<double> number_of(std::string_view text);

/// Returns the number that consists of all characters of the text, each of them a digit.
std::optional<int> digits_of(std::string_view text);

/// Returns the number of days from 1970-01-01 to a date, if the calendar has it.
std::optional<int> days_of(int year, int month, int day);

/// A time as a file gives it.
struct ReadTime {
  double time_s = 0.0;    // seconds since 1970-01-01 00:00 UTC
  bool has_zone = false;  // false: the text has neither Z nor an offset, and UTC was assumed
};

/// Reads a time such as 2023-10-02T07:45:10.5Z (ISO 8601), with any fraction and with Z, an offset
/// such as +02:00, or neither. Dates without a time of day are no times.
std::optional<ReadTime> time_of(std::string_view text);

/// Returns a time as "2023-10-02 07:45:10 UTC".
std::string utc_text(double time_s);

/// Returns a time of day as "07:45:10".
std::string clock_text(double time_s);

/// Returns a duration such as "42 s", "5 min 3 s" or "1 h 15 min".
std::string duration_text(double seconds);

/// Returns whether the text is UTF-8.
bool is_utf8(std::string_view text);

/// Returns the text in UTF-8. A text that is not UTF-8 is taken for Latin-1. Control characters
/// become spaces, and long texts are shortened.
std::string clean_text(std::string_view text);

/// Returns a number and its noun, such as "1 fix" or "1,234 fixes".
std::string counted(std::size_t count, const char* one, const char* many);

}  // namespace aerostat::track
