#include "viewer/display.hpp"

#include <QApplication>
#include <QFontMetrics>
#include <QStringList>
#include <cstdio>
#include <cstdlib>

#include "core/error.hpp"

namespace aerostat::viewer {
namespace {

/// Returns the lines that Qt printed while it looked for a display.
QStringList& told() {
  static QStringList lines;
  return lines;
}

[[noreturn]] void end(const QString& message) {
  std::fprintf(stderr, "aerostat-viewer: %s\n", qPrintable(message));
  std::fflush(stderr);
  std::_Exit(static_cast<int>(ErrorKind::no_device));
}

/// Returns "DISPLAY is ':9'" or "DISPLAY is not set" for the variable DISPLAY.
QString state_of(const char* variable) {
  const QString name = QString::fromLatin1(variable);
  if (!qEnvironmentVariableIsSet(variable)) return name + " is not set";
  return name + " is '" + qEnvironmentVariable(variable) + "'";
}

QString advice() {
  return "Expected a desktop to open a window on: " + state_of("DISPLAY") + ", " +
         state_of("WAYLAND_DISPLAY") + ", " + state_of("QT_QPA_PLATFORM") +
         ". Start it in a desktop session or by 'ssh -X' (for Wayland without X, Qt needs the "
         "package qt6-wayland). 'aerostat render' needs no display.";
}

void listen(QtMsgType type, const QMessageLogContext&, const QString& text) {
  QString line = text.simplified();
  while (line.endsWith(QLatin1Char('.'))) line.chop(1);
  if (type != QtFatalMsg) {
    told() << line;
    return;
  }
  // The text before the list of plugins is left out, because it says that aerostat may have to be
  // installed again.
  const qsizetype available = line.indexOf(QLatin1String("Available platform plugins"));
  told() << (available < 0 ? line : line.mid(available));
  end("cannot open a window: " + told().join(". ") + ". " + advice());
}

}  // namespace

void begin_display_watch() {
  // Without this setting, Qt tries Wayland only if the session says that it is one of Wayland.
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM") && qEnvironmentVariableIsEmpty("DISPLAY") &&
      !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")) {
    qputenv("QT_QPA_PLATFORM", "wayland");
  }
  qInstallMessageHandler(listen);
}

void end_display_watch() {
  qInstallMessageHandler(nullptr);
  for (const QString& line : told()) std::fprintf(stderr, "%s\n", qPrintable(line));
  told().clear();
}

void require_fonts() {
  // If there is no font, Qt still names fonts and draws boxes.
  if (QFontMetrics(QApplication::font()).inFont(QLatin1Char('A'))) return;
  end("cannot write in the window: there is no font. Expected one at least that fontconfig knows "
      "('fc-list' lists them); on Debian, install the package fonts-dejavu-core.");
}

}  // namespace aerostat::viewer
