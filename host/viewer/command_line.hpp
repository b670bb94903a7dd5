#pragma once

#include <QCommandLineParser>
#include <QString>
#include <QStringList>

namespace aerostat::viewer {

/// The command line of the window, read before there is an application: what needs no window is
/// answered without a display.
class CommandLine {
 public:
  CommandLine(int argc, char** argv);

  /// False if it asks for help or the version, or is wrong.
  bool wants_window() const;
  /// If it wants none: prints what is asked for to stdout, or what is wrong to stderr. Returns the
  /// exit code, or exits with it.
  int answer() const;

  /// Empty without one.
  QString scene() const;
  QString device() const;

 private:
  QString fault() const;

  QStringList words_;  // without Qt's own options
  QCommandLineParser parser_;
  bool is_parsed_;
};

/// Loads the window's texts, and Qt's own, in the desktop's language where they are translated.
/// Needs an application.
void load_translations();

}  // namespace aerostat::viewer
