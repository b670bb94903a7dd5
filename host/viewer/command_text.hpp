#pragma once

#include <QString>

#include "viewer/document.hpp"

namespace aerostat::viewer {

/// Returns a word in the quotes that a POSIX shell needs for it.
QString shell_word(const QString& word);

/// Returns the command that renders the document as it is now. The command names the document's
/// file and adds `--set` for every difference from it. If there is no file, or `--set` cannot
/// express the difference, the command reads the scene from standard input.
QString command_text(const Document& document, const QString& device);

}  // namespace aerostat::viewer
