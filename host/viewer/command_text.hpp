#pragma once

#include <QString>

#include "viewer/document.hpp"

namespace aerostat::viewer {

/// A word as a POSIX shell takes it.
QString shell_word(const QString& word);

/// The command that renders the document as it stands: of its file, with `--set` for what differs
/// from it, or, where there is no file or that cannot be said, with the scene on standard input.
QString command_text(const Document& document, const QString& device);

}  // namespace aerostat::viewer
