#pragma once

#include <QCommandLineParser>
#include <QString>
#include <QStringList>

namespace aerostat::viewer {

/// The command line of the window, which is read before there is an application. Requests that need
/// no window are answered without a display.
class CommandLine {
 public:
  CommandLine(int argc, char** argv);

  /// Returns false if the command line asks for help or the version, or if it is wrong.
  bool wants_window() const;
  /// Answers a command line that wants no window. Prints what it asks for to stdout, or what is
  /// wrong with it to stderr. Returns the exit code or exits with it.
  int answer() const;

  /// Returns the file of the scene, or an empty string if none is given.
  QString scene() const;
  QString device() const;

 private:
  QString fault() const;

  /// The words without Qt's own options.
  QStringList words_;
  QCommandLineParser parser_;
  bool is_parsed_;
};

/// Loads the texts of the window and of Qt in the language of the desktop if there are
/// translations. Needs an application.
void load_translations();

}  // namespace aerostat::viewer
