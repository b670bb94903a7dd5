// Tests that the man page and the completions of the window name exactly the options that --help
// shows.
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QtTest>

namespace aerostat::viewer {
namespace {

QString file_text(const QString& path) {
  QFile file(QStringLiteral(AEROSTAT_SOURCE_DIR "/") + path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Returns all matches of group 1 of the pattern.
QSet<QString> all_of(const QString& text, const QString& pattern) {
  QSet<QString> words;
  auto at = QRegularExpression(pattern).globalMatch(text);
  while (at.hasNext()) words << at.next().captured(1);
  return words;
}

}  // namespace

class ViewerDocsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void options_are_those_of_help_data();
  void options_are_those_of_help();
};

void ViewerDocsTest::options_are_those_of_help_data() {
  QTest::addColumn<QString>("path");
  QTest::addColumn<QString>("pattern");
  QTest::newRow("man") << "packaging/man/aerostat-viewer.1"
                       << "\\\\-\\\\-([a-z]+(?:\\\\-[a-z]+)*)";
  QTest::newRow("bash") << "packaging/completions/aerostat-viewer.bash"
                        << "(?<!-)--([a-z][a-z-]*)";
  QTest::newRow("zsh") << "packaging/completions/_aerostat-viewer"
                       << "--([a-z][a-z-]*)";
  QTest::newRow("fish") << "packaging/completions/aerostat-viewer.fish"
                        << "-l ([a-z][a-z-]*)";
}

void ViewerDocsTest::options_are_those_of_help() {
  QFETCH(QString, path);
  QFETCH(QString, pattern);
  QProcess program;
  program.start(QStringLiteral(AEROSTAT_VIEWER_BINARY), {"--help"});
  QVERIFY(program.waitForFinished());
  QCOMPARE(program.exitCode(), 0);
  const QString help = QString::fromUtf8(program.readAllStandardOutput());
  const auto options = all_of(help, "(?:^|\\s|, )--([a-z][a-z-]*)");
  QVERIFY2(options.contains("device"), qPrintable(help));
  QSet<QString> named;
  QString text = file_text(path);
  // This option belongs to aerostat, which the completions call.
  text.remove(QStringLiteral("devices --json"));
  for (QString word : all_of(text, pattern)) named << word.remove('\\');
  QCOMPARE(named, options);
}

}  // namespace aerostat::viewer

QTEST_GUILESS_MAIN(aerostat::viewer::ViewerDocsTest)
#include "viewer_docs_test.moc"
