#include <QApplication>
#include <clocale>
#include <cstdio>
#include <cstdlib>

#include "scene/installed.hpp"
#include "viewer/command_line.hpp"
#include "viewer/device_watch.hpp"
#include "viewer/display.hpp"
#include "viewer/main_window.hpp"

namespace {

/// Shows the window until it is closed.
int run(const aerostat::viewer::CommandLine& line) {
  aerostat::viewer::MainWindow window(line.device());
  window.show();
  if (!line.scene().isEmpty()) {
    const auto found = aerostat::scene::find_scene(line.scene().toStdString());
    window.open(QString::fromStdString(found.string()));
  }
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  namespace viewer = aerostat::viewer;
  QApplication::setApplicationName(QStringLiteral("aerostat-viewer"));
  QApplication::setOrganizationName(QStringLiteral("aerostat"));
  QApplication::setApplicationVersion(QStringLiteral(AEROSTAT_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("aerostat-viewer"));
  const viewer::CommandLine line(argc, argv);
  viewer::begin_display_watch();
  if (!line.wants_window()) return line.answer();
  const QApplication application(argc, argv);
  viewer::end_display_watch();
  // Qt has taken over the locale of the environment. Numbers in files and kernels have a dot in
  // every locale.
  std::setlocale(LC_NUMERIC, "C");
  viewer::require_fonts();
  viewer::load_translations();

  const int code = run(line);
  if (viewer::is_anything_left_behind()) {
    std::fflush(nullptr);
    std::_Exit(code);
  }
  return code;
}
