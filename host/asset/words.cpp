#include "asset/words.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include "core/error.hpp"
#include "track/text.hpp"

namespace aerostat::asset {
namespace {

constexpr std::size_t kShownLength = 80;
constexpr std::string_view kSpaces = " \t\v\f\r\n";

/// Returns a number that fills the whole of a word.
template <class Number>
std::optional<Number> number_in(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  Number number{};
  const char* const end = word.data() + word.size();
  const auto [stop, fault] = std::from_chars(word.data(), end, number);
  if (fault != std::errc() || stop != end || word.empty()) return std::nullopt;
  return number;
}

}  // namespace

void refuse(const std::string& what) {
  throw Error(ErrorKind::bad_data, what);
}

std::string in_quotes(std::string_view text) {
  std::size_t shown = std::min(text.size(), kShownLength);
  const auto is_inside = [&](std::size_t i) {
    return i > 0 && i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
  };
  while (is_inside(shown)) --shown;  // cut between the characters of UTF-8
  return fmt::format("\"{}{}\"", track::clean_text(text.substr(0, shown)),
                     shown < text.size() ? "..." : "");
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

bool Lines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  line = rest_.substr(0, end);
  const bool is_pair = rest_.substr(end, 2) == "\r\n";
  rest_.remove_prefix(std::min(end + (is_pair ? 2 : 1), rest_.size()));
  ++number_;
  return true;
}

std::string_view Words::next() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kSpaces), rest_.size()));
  const std::string_view word = rest_.substr(0, rest_.find_first_of(kSpaces));
  rest_.remove_prefix(word.size());
  return word;
}

std::string_view Words::rest() const {
  return track::trimmed(rest_);
}

std::optional<double> real_of(std::string_view word) {
  return number_in<double>(word);
}

double real_at(std::string_view word, std::size_t line) {
  const std::optional<double> number = real_of(word);
  if (number) return *number;
  if (word.empty()) refuse(fmt::format("line {}: the line ends where a number is expected", line));
  const bool has_comma = word.find(',') != std::string_view::npos;
  refuse(fmt::format("line {}: found {}, expected a number{}", line, in_quotes(word),
                     has_comma ? " whose decimal mark is a point and not a comma" : ""));
}

std::optional<std::int64_t> integer_of(std::string_view word) {
  return number_in<std::int64_t>(word);
}

}  // namespace aerostat::asset
