// Tests that everything can be reached on a small screen. The screen of this test has 640 x 400
// points, which is a screen of 1280 x 800 pixels at twice the size.
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>
#include <QtTest>

#include "small_window.hpp"
#include "viewer/color_editor.hpp"
#include "viewer/export_dialog.hpp"
#include "viewer/film_dialog.hpp"
#include "viewer/main_window.hpp"
#include "viewer/message_bar.hpp"
#include "viewer/panels.hpp"
#include "viewer/picture_view.hpp"
#include "viewer/shortcuts_dialog.hpp"

namespace aerostat::viewer {

class ScreensTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void init() { QSettings().clear(); }
  void the_window_fits();
  void a_window_of_a_larger_screen_fits();
  void long_texts_do_not_widen_it();
  void every_page_can_be_scrolled_to_its_end();
  void dialogs_fit();

 private:
  static QRect room() { return QGuiApplication::primaryScreen()->availableGeometry(); }
};

void ScreensTest::initTestCase() {
  begin_with_no_settings("aerostat-viewer-screens-test");
  QCOMPARE(room().size(), QSize(640, 400));
}

void ScreensTest::the_window_fits() {
  MainWindow window;
  window.show();
  QVERIFY(room().contains(window.geometry()));
  for (auto* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->parentWidget() != &window) continue;
    QVERIFY2(window.rect().contains(widget->geometry()), qPrintable(widget->objectName()));
  }
  QVERIFY2(window.view().width() >= 100 && window.view().height() >= 100, "no picture is seen");
}

void ScreensTest::a_window_of_a_larger_screen_fits() {
  {
    MainWindow window;
    window.show();
    window.setGeometry(900, 300, 1600, 1000);
    window.close();
  }
  MainWindow window;
  window.show();
  QVERIFY(room().contains(window.geometry()));
}

void ScreensTest::long_texts_do_not_widen_it() {
  MainWindow window;
  window.show();
  for (auto* label : window.statusBar()->findChildren<QLabel*>()) {
    label->setText(QString(200, 'm'));
  }
  window.messages().show_message(QString(300, 'm'), {{"Try Again", [] {}},
                                                     {"Use the Automatic Device", [] {}},
                                                     {"Use " + QString(60, 'd'), [] {}},
                                                     {"Use " + QString(60, 'e'), [] {}}});
  QCoreApplication::processEvents();
  QVERIFY(room().contains(window.geometry()));
  QVERIFY(window.minimumSizeHint().width() <= room().width());
  QVERIFY(window.minimumSizeHint().height() <= room().height());
}

void ScreensTest::every_page_can_be_scrolled_to_its_end() {
  MainWindow window;
  window.show();
  Panels& panels = window.panels();
  for (auto* fold : panels.findChildren<QToolButton*>()) {
    if (fold->isCheckable()) fold->setChecked(true);
  }
  for (int i = 0; i < panels.count(); ++i) {
    panels.setCurrentIndex(i);
    QCoreApplication::processEvents();
    auto* scroll = qobject_cast<QScrollArea*>(panels.widget(i));
    QVERIFY2(scroll->widget()->width() <= scroll->viewport()->width(), "it is cut at its side");
    QTRY_VERIFY(
        window.rect().contains(QRect(scroll->mapTo(&window, QPoint(0, 0)), scroll->size())));
  }
  QVERIFY(room().contains(window.geometry()));
}

void ScreensTest::dialogs_fit() {
  MainWindow window;
  window.show();
  ExportDialog export_dialog(window.document(), {}, &window);
  FilmDialog film_dialog(window.document(), {}, &window);
  ShortcutsDialog shortcuts(window);
  for (QDialog* dialog : {static_cast<QDialog*>(&export_dialog),
                          static_cast<QDialog*>(&film_dialog), static_cast<QDialog*>(&shortcuts)}) {
    dialog->show();
    QCoreApplication::processEvents();
    QVERIFY2(room().contains(dialog->geometry()), qPrintable(dialog->windowTitle()));
  }

  // A colour is asked for by a dialog that waits.
  ColorEditor color(1, 1, "Colour");
  color.show_colors("[[1, 0.5, 0.2]]");
  color.show();
  QRect place;
  bool has_buttons = false;
  QTimer::singleShot(100, &color, [&place, &has_buttons] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    place = dialog->geometry();
    auto* buttons = dialog->findChild<QDialogButtonBox*>();
    has_buttons = dialog->rect().contains(buttons->geometry());
    dialog->accept();
  });
  color.findChildren<QToolButton*>().back()->click();
  QVERIFY2(room().contains(place) && !place.isEmpty(), "of colours");
  QVERIFY(has_buttons);
}

}  // namespace aerostat::viewer

QTEST_MAIN(aerostat::viewer::ScreensTest)
#include "screens_test.moc"
