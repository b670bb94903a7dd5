#include <QApplication>
#include <QCommandLineParser>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include "scene/installed.hpp"
#include "viewer/main_window.hpp"

namespace {

/// Ours, and Qt's own for its dialogs, where the desktop's language has them.
void load_translations(QApplication& application) {
  static QTranslator own, of_qt;
  const QLocale locale;
  // English has forms of its own for one and for many.
  if (own.load(locale, QStringLiteral("aerostat"), QStringLiteral("_"),
               QStringLiteral(":/translations")) ||
      own.load(QStringLiteral(":/translations/aerostat_en.qm"))) {
    application.installTranslator(&own);
  }
  if (of_qt.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                 QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    application.installTranslator(&of_qt);
  }
}

}  // namespace

int main(int argc, char** argv) {
  // A version is told without a display, too.
  for (int i = 1; i < argc; ++i) {
    const QByteArrayView word(argv[i]);
    if (word == "--version" || word == "-v") qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("aerostat-viewer"));
  QApplication::setOrganizationName(QStringLiteral("aerostat"));
  QApplication::setApplicationVersion(QStringLiteral(AEROSTAT_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("aerostat-viewer"));
  load_translations(application);

  QCommandLineParser parser;
  parser.setApplicationDescription(
      QCoreApplication::translate("main", "Sets up a picture of aerostat by eye."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("scene"),
                               QCoreApplication::translate("main", "Scene file to open"),
                               QStringLiteral("[SCENE]"));
  const QCommandLineOption device(
      QStringLiteral("device"),
      QCoreApplication::translate("main", "What computes, as of aerostat render"),
      QStringLiteral("DEVICE"));
  parser.addOption(device);
  parser.process(application);

  aerostat::viewer::MainWindow window(parser.value(device));
  window.show();
  const QStringList scenes = parser.positionalArguments();
  if (!scenes.isEmpty()) {
    const auto found = aerostat::scene::find_scene(scenes.front().toStdString());
    window.open(QString::fromStdString(found.string()));
  }
  return QApplication::exec();
}
