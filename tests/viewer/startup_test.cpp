// Tests the answers of the program before there is a window: to questions, to wrong options, and
// without a display.
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

namespace aerostat::viewer {

class StartupTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void questions_need_no_display_data();
  void questions_need_no_display();
  void wrong_words_need_no_display_data();
  void wrong_words_need_no_display();
  void no_display_is_told_data();
  void no_display_is_told();
  void no_fonts_are_told();
  void options_of_qt_are_known();

 private:
  struct Answer {
    int code;
    bool is_crash;
    QString out, err;
  };
  using Changes = QMap<QString, QString>;
  static Answer ask(const QStringList& words, const Changes& environment);
};

/// Runs the program without a display and returns its answer. `environment` adds variables.
StartupTest::Answer StartupTest::ask(const QStringList& words, const Changes& environment) {
  QProcess program;
  auto variables = QProcessEnvironment::systemEnvironment();
  for (const char* one : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "XDG_SESSION_TYPE"}) {
    variables.remove(one);
  }
  for (auto at = environment.begin(); at != environment.end(); ++at) {
    variables.insert(at.key(), at.value());
  }
  program.setProcessEnvironment(variables);
  program.start(QStringLiteral(AEROSTAT_VIEWER_BINARY), words);
  if (!program.waitForFinished(60000)) return {-1, true, {}, "it did not end"};
  return {program.exitCode(), program.exitStatus() == QProcess::CrashExit,
          QString::fromUtf8(program.readAllStandardOutput()),
          QString::fromUtf8(program.readAllStandardError())};
}

void StartupTest::questions_need_no_display_data() {
  QTest::addColumn<QStringList>("words");
  QTest::addColumn<QString>("platform");
  QTest::addColumn<QString>("answer");
  QTest::newRow("--help") << QStringList{"--help"} << ""
                          << "--device";
  QTest::newRow("-h") << QStringList{"-h"} << ""
                      << "--device";
  QTest::newRow("--help-all") << QStringList{"--help-all"} << ""
                              << "-platform";
  QTest::newRow("--version") << QStringList{"--version"} << ""
                             << "aerostat-viewer ";
  QTest::newRow("-v") << QStringList{"-v"} << ""
                      << "aerostat-viewer ";
  QTest::newRow("after a scene") << QStringList{"snow", "--version"} << ""
                                 << "aerostat-viewer ";
  QTest::newRow("no such platform") << QStringList{"--help"} << "nonsense"
                                    << "--device";
  QTest::newRow("-platform") << QStringList{"-platform", "xcb", "--help"} << ""
                             << "--device";
}

void StartupTest::questions_need_no_display() {
  QFETCH(QStringList, words);
  QFETCH(QString, platform);
  QFETCH(QString, answer);
  const Answer told =
      ask(words, platform.isEmpty() ? Changes{} : Changes{{"QT_QPA_PLATFORM", platform}});
  QVERIFY2(!told.is_crash, qPrintable(told.err));
  QCOMPARE(told.code, 0);
  QVERIFY2(told.out.contains(answer), qPrintable(told.out));
  QCOMPARE(told.err, QString());
}

void StartupTest::wrong_words_need_no_display_data() {
  QTest::addColumn<QStringList>("words");
  QTest::addColumn<QString>("named");
  QTest::newRow("option") << QStringList{"--nonsense"} << "nonsense";
  QTest::newRow("no value") << QStringList{"--device"} << "--device";
  QTest::newRow("two scenes") << QStringList{"snow", "sand"} << "snow sand";
  QTest::newRow("after --") << QStringList{"--", "-platform", "xcb"} << "-platform xcb";
}

void StartupTest::wrong_words_need_no_display() {
  QFETCH(QStringList, words);
  QFETCH(QString, named);
  const Answer told = ask(words, {});
  QVERIFY2(!told.is_crash, qPrintable(told.err));
  QCOMPARE(told.code, 64);
  QVERIFY2(told.err.startsWith("aerostat-viewer: ") && told.err.contains(named),
           qPrintable(told.err));
  QCOMPARE(told.out, QString());
}

void StartupTest::no_display_is_told_data() {
  QTest::addColumn<QString>("variable");
  QTest::addColumn<QString>("value");
  QTest::addColumn<QString>("named");
  QTest::newRow("none") << "AEROSTAT_NONE"
                        << ""
                        << "DISPLAY is not set";
  QTest::newRow("empty") << "DISPLAY"
                         << ""
                         << "DISPLAY is ''";
  QTest::newRow("no such display") << "DISPLAY"
                                   << ":4321"
                                   << "DISPLAY is ':4321'";
  QTest::newRow("no display's name") << "DISPLAY"
                                     << "nonsense"
                                     << "DISPLAY is 'nonsense'";
  QTest::newRow("no such platform") << "QT_QPA_PLATFORM"
                                    << "nonsense"
                                    << "offscreen";
  QTest::newRow("no such compositor") << "WAYLAND_DISPLAY"
                                      << "wayland-4321"
                                      << "wayland-4321";
}

void StartupTest::no_display_is_told() {
  QFETCH(QString, variable);
  QFETCH(QString, value);
  QFETCH(QString, named);
  const Answer told = ask({}, {{variable, value}});
  QVERIFY2(!told.is_crash, qPrintable(told.err));
  QCOMPARE(told.code, 69);
  QVERIFY2(told.err.startsWith("aerostat-viewer: cannot open a window: "), qPrintable(told.err));
  QVERIFY2(told.err.contains(named), qPrintable(told.err));
  QCOMPARE(told.err.count('\n'), 1);
}

void StartupTest::no_fonts_are_told() {
  QTemporaryDir folder;
  QFile file(folder.filePath("fonts.conf"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write("<?xml version=\"1.0\"?><fontconfig></fontconfig>");
  file.close();
  const Answer told =
      ask({}, {{"QT_QPA_PLATFORM", "offscreen"}, {"FONTCONFIG_FILE", file.fileName()}});
  QVERIFY2(!told.is_crash, qPrintable(told.err));
  QCOMPARE(told.code, 69);
  QVERIFY2(told.err.contains("font"), qPrintable(told.err));
}

/// Tests that Qt's options are known. Their values are not scenes, and they are not refused. The
/// only error is the missing display.
void StartupTest::options_of_qt_are_known() {
  const Answer told = ask({"-style", "fusion", "--geometry", "9x9", "-platform", "nonsense",
                           "-style=fusion", "-reverse", "snow"},
                          {});
  QCOMPARE(told.code, 69);
}

}  // namespace aerostat::viewer

QTEST_GUILESS_MAIN(aerostat::viewer::StartupTest)
#include "startup_test.moc"
