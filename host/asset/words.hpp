#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Lines, words and numbers of texts, and errors about them.
namespace aerostat::asset {

/// Throws Error{bad_data}. `what` says what was found and what was expected, without the name of
/// the file.
[[noreturn]] void refuse(const std::string& what);

/// Returns a text of a file as messages show it: quoted, short, in UTF-8, on one line.
std::string in_quotes(std::string_view text);

/// Returns a text with its capital letters of ASCII made small.
std::string lower_case(std::string_view text);

/// Reads the lines of a text. Any line end is understood.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  /// Takes the next line without its end. Returns false if there is none.
  bool next(std::string_view& line);

  /// The number of the last line, from 1.
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// Reads the words of a line, which white space separates.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  /// Takes the next word, or an empty one at the end.
  std::string_view next();

  /// Returns what is left of the line, without white space at its ends.
  std::string_view rest() const;

 private:
  std::string_view rest_;
};

/// Returns the number that the whole word is, whatever the locale. It may be infinite or not a
/// number, if the word says so.
std::optional<double> real_of(std::string_view word);

/// Returns the number that the whole word is. Throws Error{bad_data} that says so if it is none,
/// and what is wrong with decimal commas. `line` is the number of the line, for the message.
double real_at(std::string_view word, std::size_t line);

/// Returns the integer that the whole word is.
std::optional<std::int64_t> integer_of(std::string_view word);

}  // namespace aerostat::asset
