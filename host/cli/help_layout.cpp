#include "cli/help_layout.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string_view>
#include <system_error>

#include <sys/ioctl.h>
#include <unistd.h>

#include "core/environment.hpp"

namespace aerostat::cli {

namespace {

constexpr int kLeastColumns = 40;
constexpr int kMostColumns = 100;
constexpr int kUsualColumns = 80;

/// Returns the number in COLUMNS, or 0 if it is not a number.
int columns_of_environment() {
  const std::string text = environment_variable("COLUMNS").value_or("");
  int columns = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, columns);
  return error == std::errc() && rest == end ? std::max(columns, 0) : 0;
}

int columns_of_terminal() {
  winsize size{};
  return ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

/// Returns the column where the description of a line begins, after two spaces or more. Returns
/// the column where the line begins if it has no description or if the description would have
/// little room.
std::size_t hanging_indent(const std::string& line, std::size_t columns) {
  const std::size_t first = line.find_first_not_of(' ');
  const std::size_t gap = line.find("  ", first);
  if (gap == std::string::npos) return first;
  const std::size_t description = line.find_first_not_of(' ', gap);
  return description != std::string::npos && description * 3 < columns * 2 ? description : first;
}

/// Breaks one line at spaces. `mark` ends each part but the last.
void break_line(std::string line, std::size_t columns, std::size_t indent, std::string_view mark,
                std::string& text) {
  while (line.size() > columns) {
    const std::size_t start = line.find_first_not_of(' ');
    std::size_t end = line.rfind(' ', columns - mark.size());
    if (end == std::string::npos || end <= std::max(start, indent)) {
      end = line.find(' ', std::max(start, indent));
      if (end == std::string::npos) break;
    }
    text += line.substr(0, line.find_last_not_of(' ', end) + 1);
    text += mark;
    text += '\n';
    line = std::string(indent, ' ') +
           line.substr(std::min(line.find_first_not_of(' ', end), line.size()));
  }
  text += line + "\n";
}

}  // namespace

int help_columns() {
  int columns = columns_of_environment();
  if (columns == 0) columns = columns_of_terminal();
  if (columns == 0) columns = kUsualColumns;
  return std::clamp(columns, kLeastColumns, kMostColumns);
}

int description_column(int columns) {
  return std::min(34, columns * 2 / 5);
}

std::string wrapped(const std::string& text, int columns) {
  const auto room = static_cast<std::size_t>(columns);
  std::istringstream lines(text);
  std::string result;
  bool in_examples = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line[0] != ' ') in_examples = line == "Examples:";
    if (line.size() <= room) {
      result += line + "\n";
    } else if (in_examples) {
      break_line(line, room, 6, " \\", result);
    } else {
      break_line(line, room, hanging_indent(line, room), "", result);
    }
  }
  return result;
}

}  // namespace aerostat::cli
