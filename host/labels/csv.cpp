#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "labels/place_limits.hpp"
#include "labels/places.hpp"
#include "track/text.hpp"

namespace aerostat::labels {
namespace {

using Row = std::vector<std::string>;
using Column = std::optional<std::size_t>;

constexpr std::size_t kMostColumns = 1000;

/// Reads a table row by row.
class Table {
 public:
  Table(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
    const std::string_view header = text.substr(0, text.find_first_of("\r\n"));
    auto most = std::count(header.begin(), header.end(), separator_);
    for (const char separator : {';', '\t'}) {
      const auto count = std::count(header.begin(), header.end(), separator);
      if (count > most) separator_ = separator;
      most = std::max(most, count);
    }
  }

  char separator() const { return separator_; }

  /// The line on which the row begins that was read last.
  int line() const { return line_; }

  /// Reads the next row that is not empty. Returns false at the end.
  bool next(Row& row) {
    while (at_ < text_.size()) {
      line_ = next_line_;
      row.assign(1, {});
      while (at_ < text_.size() && !ends_row(text_[at_])) take_cell(row);
      skip_end_of_line();
      if (row.size() > 1 || !track::trimmed(row[0]).empty()) return true;
    }
    return false;
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw Error(ErrorKind::bad_data, fmt::format("{}:{}: {}", name_, line_, message));
  }

 private:
  static bool ends_row(char c) { return c == '\n' || c == '\r'; }

  void skip_end_of_line() {
    if (at_ >= text_.size()) return;
    ++next_line_;
    at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
  }

  /// Adds a piece of a row: a separator, a quoted text or plain text.
  void take_cell(Row& row) {
    const char c = text_[at_];
    if (c == separator_) {
      if (row.size() == kMostColumns) fail("found more than 1000 columns, expected fewer");
      row.emplace_back();
      ++at_;
    } else if (c == '"' && row.back().empty()) {
      ++at_;
      take_quoted(row.back());
    } else {
      row.back() += c;
      ++at_;
    }
  }

  void take_quoted(std::string& cell) {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"' && text_.substr(at_, 2) != "\"\"") {
        ++at_;
        return;
      }
      if (c == '"') ++at_;
      if (c == '\n') ++next_line_;
      cell += c;
    }
    fail("found a quotation mark without its end");
  }

  std::string_view text_;
  std::string name_;
  char separator_ = ',';
  std::size_t at_ = 0;
  int line_ = 1, next_line_ = 1;
};

std::string lower(std::string_view text) {
  std::string low(track::trimmed(text));
  std::transform(low.begin(), low.end(), low.begin(), [](char c) {
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return low;
}

Column column_of(const Row& header, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    for (std::size_t i = 0; i < header.size(); ++i) {
      if (lower(header[i]) == name) return i;
    }
  }
  return std::nullopt;
}

struct Columns {
  Column name, latitude, longitude, height;
};

Columns columns_of(Table& table) {
  Row header;
  Columns columns;
  if (table.next(header)) {
    columns = {column_of(header, {"name"}), column_of(header, {"lat", "latitude", "latitude_deg"}),
               column_of(header, {"lon", "lng", "longitude", "longitude_deg"}),
               column_of(header, {"ele", "elevation", "height", "height_m"})};
  }
  if (columns.name && columns.latitude && columns.longitude) return columns;
  table.fail(
      "found no header with the columns name, lat (or latitude) and lon (or longitude), which a "
      "table of places begins with");
}

/// Returns the number in a cell, or nothing if the row has no such cell or an empty one.
std::optional<double> number_in(const Table& table, const Row& row, Column column,
                                const char* what) {
  if (!column || *column >= row.size() || track::trimmed(row[*column]).empty()) return std::nullopt;
  std::string text = row[*column];
  if (table.separator() != ',') std::replace(text.begin(), text.end(), ',', '.');
  const std::optional<double> number = track::number_of(text);
  if (!number) {
    table.fail(fmt::format("found the {} '{}', expected a number", what,
                           track::clean_text(std::string_view(row[*column]).substr(0, 40))));
  }
  return number;
}

}  // namespace

std::vector<NamedPlace> places_of_csv(std::string_view text, const std::string& name) {
  Table table(text, name);
  const Columns columns = columns_of(table);
  std::vector<NamedPlace> places;
  Row row;
  while (table.next(row)) {
    const std::string label =
        *columns.name < row.size() ? track::clean_text(row[*columns.name]) : std::string();
    if (track::trimmed(label).empty()) continue;
    const auto latitude = number_in(table, row, columns.latitude, "latitude");
    const auto longitude = number_in(table, row, columns.longitude, "longitude");
    if (!latitude || !longitude) table.fail("found no latitude or no longitude, expected both");
    NamedPlace place{std::string(track::trimmed(label)),
                     {*latitude, *longitude},
                     number_in(table, row, columns.height, "height")};
    const std::string fault = fault_of(place);
    if (!fault.empty()) table.fail("found the " + fault);
    if (places.size() == kMostPlaces) table.fail("found more than 100000 places, expected fewer");
    places.push_back(std::move(place));
  }
  require_places(places, name);
  return places;
}

}  // namespace aerostat::labels
