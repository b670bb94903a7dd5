#include "viewer/command_line.hpp"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <cstdio>

#include "core/error.hpp"

namespace aerostat::viewer {
namespace {

// The options with a value that QApplication and its platforms take for themselves, with one dash
// or two. The value is the next word, or follows an equals sign.
const QStringList kValuesOfQt = {"platform",      "platformpluginpath",
                                 "platformtheme", "plugin",
                                 "geometry",      "qwindowgeometry",
                                 "title",         "qwindowtitle",
                                 "icon",          "qwindowicon",
                                 "session",       "display",
                                 "style",         "visual",
                                 "stylesheet"};
const QStringList kFlagsOfQt = {"reverse", "widgetcount", "nograb", "dograb", "sync"};

/// Returns the option's name, or an empty string for a word that is not an option.
QString option_name(const QString& word) {
  if (!word.startsWith(QLatin1Char('-'))) return {};
  return word.mid(word.startsWith(QLatin1String("--")) ? 2 : 1).section(QLatin1Char('='), 0, 0);
}

QStringList without_options_of_qt(const QStringList& words) {
  QStringList own;
  for (qsizetype i = 0; i < words.size(); ++i) {
    const QString& word = words[i];
    if (word == QLatin1String("--")) return own + words.mid(i);
    const QString name = option_name(word);
    if (kValuesOfQt.contains(name)) {
      if (!word.contains(QLatin1Char('='))) ++i;
    } else if (!kFlagsOfQt.contains(name)) {
      own << word;
    }
  }
  return own;
}

QStringList words_of(int argc, char** argv) {
  QStringList words;
  for (int i = 0; i < argc; ++i) words << QString::fromLocal8Bit(argv[i]);
  return words;
}

void add_options(QCommandLineParser& parser) {
  parser.setApplicationDescription(
      QCoreApplication::translate("main", "Sets up a picture of aerostat by eye."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("scene"),
                               QCoreApplication::translate("main", "Scene file to open"),
                               QStringLiteral("[SCENE]"));
  parser.addOption({QStringLiteral("device"),
                    QCoreApplication::translate("main", "What computes, as of aerostat render"),
                    QStringLiteral("DEVICE")});
}

}  // namespace

void load_translations() {
  static QTranslator own, of_qt;
  const QLocale locale;
  // The English texts are loaded as well, because they have different forms for one and for many.
  if (own.load(locale, QStringLiteral("aerostat"), QStringLiteral("_"),
               QStringLiteral(":/translations")) ||
      own.load(QStringLiteral(":/translations/aerostat_en.qm"))) {
    QCoreApplication::installTranslator(&own);
  }
  if (of_qt.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                 QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    QCoreApplication::installTranslator(&of_qt);
  }
}

CommandLine::CommandLine(int argc, char** argv)
    : words_(without_options_of_qt(words_of(argc, argv))) {
  add_options(parser_);
  is_parsed_ = parser_.parse(words_);
}

QString CommandLine::fault() const {
  if (!is_parsed_) return parser_.errorText();
  const QStringList scenes = parser_.positionalArguments();
  if (scenes.size() < 2) return {};
  return QCoreApplication::translate("main", "Expected one scene at most, found %1: %2.")
      .arg(QString::number(scenes.size()), scenes.join(QLatin1Char(' ')));
}

bool CommandLine::wants_window() const {
  for (const char* question : {"help", "help-all", "version"}) {
    if (parser_.isSet(QString::fromLatin1(question))) return false;
  }
  return fault().isEmpty();
}

int CommandLine::answer() const {
  // Only an application of Qt prints Qt's options. The platform "offscreen" needs no screen.
  QByteArray words[] = {words_.value(0).toLocal8Bit(), "-platform", "offscreen"};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  int count = 3;
  const QApplication application(count, arguments);
  load_translations();
  QCommandLineParser translated;
  add_options(translated);
  // Help comes before errors, as it does in Qt.
  const bool is_parsed = translated.parse(words_);
  if (is_parsed &&
      (translated.isSet(QStringLiteral("help")) || translated.isSet(QStringLiteral("help-all")) ||
       translated.isSet(QStringLiteral("version")))) {
    translated.process(words_);
  }
  const QString why = is_parsed ? fault() : translated.errorText();
  std::fprintf(stderr, "aerostat-viewer: %s\n%s\n", qPrintable(why),
               qPrintable(QCoreApplication::translate(
                   "main", "aerostat-viewer --help lists what can be asked for.")));
  return static_cast<int>(ErrorKind::usage);
}

QString CommandLine::scene() const {
  return parser_.positionalArguments().value(0);
}

QString CommandLine::device() const {
  return parser_.value(QStringLiteral("device"));
}

}  // namespace aerostat::viewer
