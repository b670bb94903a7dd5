#pragma once

#include <QString>

namespace aerostat::viewer {

/// Begins to watch Qt's search for a display. Call it before QApplication is made. If QApplication
/// finds no display, the process ends with the exit code of ErrorKind::no_device and a message on
/// stderr that says what was tried and what to do. Without the watch, Qt would abort. All other
/// messages of Qt are held back.
void begin_display_watch();

/// Ends the watch when there is a display. Prints the messages that were held back, and lets Qt
/// print later messages itself.
void end_display_watch();

/// Ends the process with the same exit code if there is no font to write with. Needs a
/// QApplication.
void require_fonts();

}  // namespace aerostat::viewer
