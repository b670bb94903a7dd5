#pragma once

#include <QString>

namespace aerostat::viewer {

/// To be called before QApplication is made. If that finds no display, the process ends with the
/// exit code of ErrorKind::no_device and with a message on stderr that says what was tried and what
/// to do, where Qt would abort. What else Qt says is held back.
void begin_display_watch();

/// There is a display: prints what was held back, and later messages go where Qt sends them.
void end_display_watch();

/// Ends the process alike if there is no font to write with. Needs a QApplication.
void require_fonts();

}  // namespace aerostat::viewer
