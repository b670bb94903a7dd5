#pragma once

#include <string>

/// These functions lay out the text of --help for the terminal.
namespace aerostat::cli {

/// Returns the number of columns for help on stdout, from 40 to 100, because longer lines are
/// hard to read. It is the number in COLUMNS, or else the width of the terminal, or else 80.
int help_columns();

/// Returns the column at which descriptions of options begin.
int description_column(int columns);

/// Returns the text broken into lines of at most `columns` characters, if the words allow that.
/// The rest of a line stands below its description, or below its own beginning if it has none. An
/// example, which is a line of two spaces and a command after "Examples:", is broken by a
/// backslash, so that it can still be copied.
std::string wrapped(const std::string& text, int columns);

}  // namespace aerostat::cli
