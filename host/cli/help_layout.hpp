#pragma once

#include <string>

/// How the text of --help is laid out for the terminal.
namespace aerostat::cli {

/// Columns for help on stdout: those that COLUMNS says, or else its terminal has, or else 80; 40 to
/// 100, since longer lines are hard to read.
int help_columns();

/// The column at which descriptions of options begin.
int description_column(int columns);

/// The text with lines of at most `columns` characters, if words allow. A line that goes on does so
/// below its description, or below its own beginning; an example, a line of two spaces and a
/// command after "Examples:", goes on behind a backslash, so that it can still be copied.
std::string wrapped(const std::string& text, int columns);

}  // namespace aerostat::cli
