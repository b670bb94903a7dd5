// Tests that numbers, dates and times are read alike in every country, and that unreadable text
// changes nothing.
#include <QDateEdit>
#include <QDoubleSpinBox>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTimeEdit>
#include <QToolButton>
#include <QtTest>
#include <cmath>

#include "scene/scene.hpp"
#include "small_window.hpp"
#include "viewer/camera_control.hpp"
#include "viewer/command_text.hpp"
#include "viewer/export_dialog.hpp"
#include "viewer/main_window.hpp"
#include "viewer/number_box.hpp"
#include "viewer/panels.hpp"
#include "viewer/sun_panel.hpp"

namespace aerostat::viewer {
namespace {

const QStringList kLocales = {"C",     "en_US", "en_IN", "de_DE", "de_CH",
                              "fr_FR", "ru_RU", "ar_EG", "fa_IR", "sv_SE"};

void type(QAbstractSpinBox& box, const QString& text, Qt::Key end = Qt::Key_Return) {
  box.setFocus();
  box.selectAll();
  // QTest::keyClicks knows only the keys of ASCII.
  for (const QChar character : text) {
    QKeyEvent press(QEvent::KeyPress, 0, Qt::NoModifier, QString(character));
    QCoreApplication::sendEvent(&box, &press);
  }
  if (end != Qt::Key_unknown) QTest::keyClick(&box, end);
}

/// Pastes a text that nobody types, but that a clipboard may hold.
void put(QAbstractSpinBox& box, const QString& text) {
  auto* line = box.findChild<QLineEdit*>();
  line->selectAll();
  line->insert(text);
  QTest::keyClick(&box, Qt::Key_Return);
}

bool has_red_frame(QWidget& widget) {
  const QColor corner = widget.grab().toImage().pixelColor(0, widget.height() / 2);
  return corner.red() > 180 && corner.green() < 100 && corner.blue() < 100;
}

}  // namespace

class LocalesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { begin_with_no_settings("aerostat-viewer-locales-test"); }
  void cleanup() { QLocale::setDefault(QLocale::c()); }
  void texts_are_read_data();
  void texts_are_read();
  void boxes_show_what_they_read_data() { add_locales(); }
  void boxes_show_what_they_read();
  void both_marks_change_the_scene_data() { add_locales(); }
  void both_marks_change_the_scene();
  void what_is_no_number_changes_nothing_data() { add_locales(); }
  void what_is_no_number_changes_nothing();
  void whole_numbers_take_no_marks_data() { add_locales(); }
  void whole_numbers_take_no_marks();
  void every_box_reads_both_marks();
  void sun_by_date_and_place_data() { add_locales(); }
  void sun_by_date_and_place();
  void exports_are_as_large_as_was_typed_data() { add_locales(); }
  void exports_are_as_large_as_was_typed();
  void a_shortcut_takes_what_was_typed();
  void files_and_commands_are_the_same_data() { add_locales(); }
  void files_and_commands_are_the_same();

 private:
  void add_locales() {
    QTest::addColumn<QString>("name");
    for (const QString& name : kLocales) QTest::newRow(qPrintable(name)) << name;
  }
  /// Sets the locale of all widgets that are made later, as the system's own locale is set for the
  /// program.
  static void use_locale() {
    QFETCH(QString, name);
    QLocale::setDefault(QLocale(name));
  }
};

/// The panels of the window with a document of their own.
struct Desk {
  Document document;
  CameraControl camera{document};
  Panels panels{document, camera};

  Desk() {
    panels.show();
    for (auto* fold : panels.findChildren<QToolButton*>()) {
      if (fold->isCheckable()) fold->setChecked(true);
    }
  }
  template <typename Box>
  Box& box(const char* pointer, int index = 0) {
    auto* editor = panels.findChild<QWidget*>(QString::fromLatin1(pointer));
    if (auto* box = qobject_cast<Box*>(editor)) return *box;
    return *editor->findChildren<Box*>().at(index);
  }
};

void LocalesTest::texts_are_read_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<double>("decimal");
  QTest::addColumn<double>("whole");
  const double no = std::nan("");
  const auto row = [](const char* text, double decimal, double whole) {
    QTest::newRow(text) << QString::fromUtf8(text) << decimal << whole;
  };
  row("7", 7, 7);
  row("-12", -12, -12);
  row("+3", 3, 3);
  row("0.6", 0.6, no);
  row("0,25", 0.25, no);
  row(",5", 0.5, no);
  row("-.5", -0.5, no);
  row("5,", 5, no);
  row(" 30.5 ", 30.5, no);
  row("1.234", 1.234, no);
  row("1,234", 1.234, no);
  row("1e3", 1000, 1000);
  row("2,5E-1", 0.25, no);
  row("1.234,5", 1234.5, no);
  row("1,234.5", 1234.5, no);
  row("1.234.567", 1234567, 1234567);
  row("1,234,567.25", 1234567.25, no);
  row("12,34,567.5", 1234567.5, no);
  row("1 234", 1234, 1234);
  row("1 234,5", 1234.5, no);
  row("1\u202f234\u00a0567", 1234567, 1234567);
  row("1'234.5", 1234.5, no);
  row("1’234’567", 1234567, 1234567);
  row("١٬٢٣٤٫٥", 1234.5, no);
  row("٠٫٦", 0.6, no);
  row("٠،٦", 0.6, no);
  row("\u061c-١٢٣٤٫٥٠", -1234.5, no);
  row("\u200e−۱۲۳۴٫۵", -1234.5, no);
  row("६.५", 6.5, no);
  row("１．５", 1.5, no);
  row("−4", -4, -4);
  for (const char* nothing :
       {"",       "-",         ".",           ",",       "abc",        "nan",
        "inf",    "0x10",      "1e",          "1e+",     "1e400",      "1.2.3",
        "1,2,3",  "1.23,4,5",  "1.234,567.8", "12.34,5", "1234.567,8", "1 23",
        "1 2345", "0.123.456", "0,123.5",     "1  234",  "1'234 567",  "1..5",
        "1.,5",   "--1",       "1-",          "1,5 km",  "½",          "1_000",
        "1٫2٫3",  "1٫2.3",     "1.5e2.5",     "²"}) {
    row(nothing, no, no);
  }
}

void LocalesTest::texts_are_read() {
  QFETCH(QString, text);
  QFETCH(double, decimal);
  QFETCH(double, whole);
  const auto is = [](std::optional<double> read, double wanted) {
    return read ? *read == wanted : std::isnan(wanted);
  };
  QVERIFY(is(read_number(text, NumberKind::decimal), decimal));
  QVERIFY(is(read_number(text, NumberKind::whole), whole));
}

/// Tests that a box reads the number that it shows.
void LocalesTest::boxes_show_what_they_read() {
  use_locale();
  NumberBox box;
  box.setDecimals(3);
  box.setRange(-1e9, 1e9);
  box.setSuffix(" m");
  for (const double value : {0.0, 0.6, -0.25, 1.234, 8000.0, -1234.5, 1234567.0, 4e8, 0.001}) {
    box.setValue(value);
    const QString shown = box.text();
    box.setValue(-77.0);
    put(box, QString(shown).remove(" m"));
    QCOMPARE(box.value(), value);
    QCOMPARE(box.text(), shown);
  }
}

void LocalesTest::both_marks_change_the_scene() {
  use_locale();
  Desk desk;
  auto& roughness = desk.box<QDoubleSpinBox>("/terrain/fractal/gain");
  for (const char* text : {"0.6", "0,6", "٠٫٦", "۰٫۶", " 0,6 ", ".6", "6e-1"}) {
    type(roughness, "0.3");
    type(roughness, QString::fromUtf8(text));
    QCOMPARE(roughness.value(), 0.6);
    QCOMPARE(desk.document.value("/terrain/fractal/gain"), QString("0.6"));
  }
  desk.panels.lamps().add();
  auto& x = desk.box<QDoubleSpinBox>("/lights/0/position", 0);
  for (const char* text : {"1234.5", "1234,5", "1.234,5", "1,234.5", "1 234,5", "1’234.5"}) {
    type(x, "0");
    type(x, QString::fromUtf8(text));
    QCOMPARE(x.value(), 1234.5);
    QCOMPARE(desk.document.scene().lights.at(0).position.x, 1234.5);
  }
}

void LocalesTest::what_is_no_number_changes_nothing() {
  use_locale();
  Desk desk;
  auto& roughness = dynamic_cast<NumberBox&>(desk.box<QDoubleSpinBox>("/terrain/fractal/gain"));
  type(roughness, "0.6");
  QVERIFY(!has_red_frame(roughness));
  const std::string before = desk.document.source().text();
  for (const char* text : {"0.6.1", "x", "0,,6", "1,23,4", "900"}) {
    type(roughness, text);
    QVERIFY(!roughness.is_readable());
    QVERIFY2(roughness.text().contains(text), "it was taken away before it could be mended");
    QVERIFY(has_red_frame(roughness));
    QCOMPARE(roughness.value(), 0.6);
    QCOMPARE(desk.document.source().text(), before);
    roughness.clearFocus();
    QVERIFY(has_red_frame(roughness));
    QCOMPARE(desk.document.source().text(), before);
  }
  QVERIFY(roughness.expected().contains(roughness.textFromValue(0.6)));
  type(roughness, "0,7");
  QVERIFY(roughness.is_readable());
  QVERIFY(!has_red_frame(roughness));
  QCOMPARE(roughness.value(), 0.7);
}

void LocalesTest::whole_numbers_take_no_marks() {
  use_locale();
  Desk desk;
  auto& width = dynamic_cast<NumberBox&>(desk.box<QDoubleSpinBox>("/image/width"));
  auto& seed = dynamic_cast<NumberBox&>(desk.box<QDoubleSpinBox>("/terrain/seed"));
  for (NumberBox* box : {&width, &seed}) {
    type(*box, "640");
    QCOMPARE(box->value(), 640.0);
    for (const char* text : {"1,920", "1.920", "0,25", "12.5", "12.0"}) {
      type(*box, text);
      QVERIFY(!box->is_readable());
      QCOMPARE(box->value(), 640.0);
    }
  }
  type(width, "1 920");
  QCOMPARE(width.value(), 1920.0);
  type(seed, "4294967295");
  QCOMPARE(desk.document.scene().terrain.seed, 4294967295u);
}

/// Tests that no box was forgotten. None of them reads numbers in a way of Qt's own.
void LocalesTest::every_box_reads_both_marks() {
  Desk desk;
  const auto boxes = desk.panels.findChildren<QAbstractSpinBox*>();
  QVERIFY(boxes.size() > 50);
  for (QAbstractSpinBox* box : boxes) {
    const bool dated = qobject_cast<QDateTimeEdit*>(box) != nullptr;
    // The year in the calendar is Qt's own box. It takes a whole number of four digits.
    if (box->objectName() == "qt_calendar_yearedit") continue;
    QVERIFY2(dated || dynamic_cast<NumberBox*>(box) != nullptr,
             qPrintable(box->objectName() + " of " + box->parentWidget()->objectName()));
  }
  ExportDialog dialog(desk.document, {});
  for (QAbstractSpinBox* box : dialog.findChildren<QAbstractSpinBox*>()) {
    QVERIFY(dynamic_cast<WholeBox*>(box) != nullptr);
  }
}

void LocalesTest::sun_by_date_and_place() {
  use_locale();
  Desk desk;
  desk.panels.sun().set_date();
  type(desk.box<QDoubleSpinBox>("/sun/latitude_deg"), "46,5125");
  type(desk.box<QDoubleSpinBox>("/sun/longitude_deg"), "-123.4567");
  QCOMPARE(desk.document.value("/sun/latitude_deg"), QString("46.5125"));
  QCOMPARE(desk.document.value("/sun/longitude_deg"), QString("-123.4567"));
  auto* date = desk.panels.findChild<QDateEdit*>();
  auto* time = desk.panels.findChild<QTimeEdit*>();
  QCOMPARE(date->text(), QString("2024-06-21"));
  for (const char* text : {"2023-12-05", "٢٠٢٣-١٢-٠٥", "۲۰۲۳-۱۲-۰۵"}) {
    type(*date, "2024-06-21");
    type(*date, QString::fromUtf8(text));
    QCOMPARE(desk.document.value("/sun/date"), QString("\"2023-12-05\""));
  }
  type(*time, QString::fromUtf8("١٨:٤٥"));
  QCOMPARE(desk.document.value("/sun/time"), QString("\"18:45+02:00\""));
  QCOMPARE(time->text(), QString("18:45"));
  for (auto* box : desk.panels.findChildren<QDoubleSpinBox*>()) {
    if (!box->prefix().startsWith("UTC")) continue;
    type(*box, "-3,5");
    QCOMPARE(desk.document.value("/sun/time"), QString("\"18:45-03:30\""));
    type(*box, "5.75");
    QCOMPARE(desk.document.value("/sun/time"), QString("\"18:45+05:45\""));
  }
}

void LocalesTest::exports_are_as_large_as_was_typed() {
  use_locale();
  Document document;
  ExportDialog dialog(document, {});
  dialog.show();
  WholeBox* width = nullptr;
  for (auto* box : dialog.findChildren<QSpinBox*>()) {
    if (box->value() == document.scene().image.width) width = dynamic_cast<WholeBox*>(box);
  }
  QVERIFY(width != nullptr);
  QVERIFY(QTest::qWaitForWindowActive(&dialog));
  type(*width, "640", Qt::Key_Tab);
  QCOMPARE(width->value(), 640);
  for (const char* text : {"1,5", "1.920", "9x", "99999"}) {
    for (const Qt::Key end : {Qt::Key_unknown, Qt::Key_Tab, Qt::Key_Return}) {
      type(*width, text, end);
      QCOMPARE(width->value(), 640);
      dialog.begin();
      QVERIFY2(!dialog.is_busy(),
               qPrintable(QString("%1, key %2: a picture is made whose size nobody asked for")
                              .arg(text)
                              .arg(end)));
      QVERIFY(!dialog.message().isEmpty());
    }
  }
  type(*width, "1", Qt::Key_unknown);
  // This path lets nothing be rendered.
  dialog.set_path("/proc/no.png");
  QSignalSpy ended(&dialog, &ExportDialog::ended);
  dialog.begin();
  QCOMPARE(width->value(), 1);
  QVERIFY(!dialog.is_busy() || ended.wait());
}

void LocalesTest::a_shortcut_takes_what_was_typed() {
  QTemporaryDir folder;
  MainWindow window;
  window.document().start(small_scene(), {});
  QVERIFY(window.document().save(folder.filePath("scene.json")));
  window.show();
  auto* box =
      window.panels().findChild<QWidget*>("/terrain/fractal/gain")->findChild<QDoubleSpinBox*>();
  QVERIFY(QTest::qWaitForWindowActive(&window));
  type(*box, "0,6", Qt::Key_unknown);
  QTest::keyClick(&window, Qt::Key_S, Qt::ControlModifier);
  QCOMPARE(window.document().saved().value("/terrain/fractal/gain"), std::string("0.6"));
}

void LocalesTest::files_and_commands_are_the_same() {
  use_locale();
  Desk desk;
  QTemporaryDir folder;
  desk.document.start(small_scene(), {});
  type(desk.box<QDoubleSpinBox>("/terrain/fractal/gain"), "0,6");
  QVERIFY(desk.document.set("place", "/balloon/position", "[98765.25, 900.25, 12]"));
  desk.panels.balloons().add();
  QVERIFY(desk.document.save(folder.filePath("scene.json")));
  QFile file(folder.filePath("scene.json"));
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QByteArray text = file.readAll();
  QVERIFY2(text.contains("0.6") && text.contains("98765.25"), text.constData());
  QVERIFY(!QJsonDocument::fromJson(text).isNull());
  for (const char byte : text) QVERIFY(static_cast<unsigned char>(byte) < 128);
  QVERIFY(desk.document.set("seed", "/terrain/fractal/gain", "0.75"));
  QVERIFY(command_text(desk.document, {}).contains("gain=0.75"));
}

}  // namespace aerostat::viewer

QTEST_MAIN(aerostat::viewer::LocalesTest)
#include "locales_test.moc"
