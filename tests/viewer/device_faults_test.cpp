// Tests the window with a driver that hangs or loses its device. The driver is tests/fake_opencl.
#include <QAbstractButton>
#include <QDir>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtTest>
#include <cstdio>
#include <cstdlib>

#include "scene/scene.hpp"
#include "small_window.hpp"
#include "viewer/device_watch.hpp"
#include "viewer/export_dialog.hpp"
#include "viewer/film_dialog.hpp"
#include "viewer/main_window.hpp"
#include "viewer/message_bar.hpp"

namespace aerostat::viewer {
namespace {

/// The longest wait in milliseconds. Kernels may have to be compiled first.
constexpr int kPatience_ms = 180000;
/// A bound in milliseconds that also holds on a machine that is busy with something else.
constexpr qint64 kSoon_ms = 5000;

/// The driver counts the calls of all tests together. Each test renders until its fault comes.
/// Only EXR files clear guides, and the first time when kernels are built. The second time is in
/// the export that hangs, and the sixth time in the second frame of the film.
constexpr const char* kFaults =
    "clWaitForEvents:30:hang,clEnqueueMapBuffer:60:hang,clEnqueueNDRangeKernel@shade_hits:600:-2,"
    "clEnqueueNDRangeKernel@clear_guides:2:hang,clEnqueueNDRangeKernel@clear_guides:6:hang";

}  // namespace

class DeviceFaultsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void init();
  void cleanup() { window_.reset(); }
  void a_hang_is_told_and_tried_again();
  void a_hang_does_not_keep_the_window_open();
  void a_lost_device_is_told_and_tried_again();
  void an_export_whose_device_hangs_is_given_up();
  void a_film_whose_device_hangs_is_given_up();

 private:
  /// Changes the scene until the message bar tells something.
  bool change_until_told();
  bool wait_until_done();
  /// Returns the button in the message bar whose text contains `text`, or null if there is none.
  QAbstractButton* offer(const QString& text) const;

  std::unique_ptr<MainWindow> window_;
  QTemporaryDir folder_;
  int changes_ = 0;
};

void DeviceFaultsTest::initTestCase() {
  qputenv("OCL_ICD_VENDORS", AEROSTAT_FAKE_OPENCL_DIR);
  qputenv("FAKE_CL_FAULTS", kFaults);
  // A busy machine makes signs late, but hardly by this time.
  qputenv("AEROSTAT_DEVICE_TIMEOUT", "4s");
  begin_with_no_settings("aerostat-viewer-device-faults-test");
}

void DeviceFaultsTest::init() {
  window_ = std::make_unique<MainWindow>();
  window_->document().start(small_scene(), {});
  window_->show();
}

bool DeviceFaultsTest::change_until_told() {
  QElapsedTimer watch;
  watch.start();
  while (window_->messages().message().isEmpty() && watch.elapsed() < kPatience_ms) {
    const auto done = [this] {
      return !window_->messages().message().isEmpty() ||
             (window_->shown() && window_->shown()->request == window_->request() &&
              window_->shown()->preview.complete);
    };
    if (!QTest::qWaitFor(done, kPatience_ms)) return false;
    if (!window_->messages().message().isEmpty()) break;
    window_->document().set("sun", "/sun/azimuth_deg", QString::number(++changes_ % 360));
  }
  return !window_->messages().message().isEmpty();
}

bool DeviceFaultsTest::wait_until_done() {
  return QTest::qWaitFor(
      [this] {
        const auto& shown = window_->shown();
        return shown && shown->preview.complete && shown->request == window_->request();
      },
      kPatience_ms);
}

QAbstractButton* DeviceFaultsTest::offer(const QString& text) const {
  for (auto* button : window_->messages().findChildren<QAbstractButton*>()) {
    if (button->text().contains(text) && !button->isHidden()) return button;
  }
  return nullptr;
}

void DeviceFaultsTest::a_hang_is_told_and_tried_again() {
  QVERIFY(change_until_told());
  QVERIFY2(window_->messages().message().contains("has not answered for 4 s"),
           qPrintable(window_->messages().message()));
  QVERIFY(!is_anything_left_behind());
  auto* again = offer("Try Again");
  QVERIFY(again != nullptr);
  QElapsedTimer watch;
  watch.start();
  again->click();
  QVERIFY2(watch.elapsed() < kSoon_ms, qPrintable(QString::number(watch.elapsed())));
  QVERIFY(is_anything_left_behind());
  QVERIFY(wait_until_done());
  QVERIFY(window_->messages().message().isEmpty());
  QVERIFY(window_->document().set("seed", "/terrain/seed", "77"));
  QVERIFY(wait_until_done());
}

void DeviceFaultsTest::a_hang_does_not_keep_the_window_open() {
  QVERIFY(change_until_told());
  QVERIFY(window_->messages().message().contains("has not answered"));
  // The scene can still be saved.
  const QString path = folder_.filePath("kept.json");
  QVERIFY(window_->document().save(path));
  QElapsedTimer watch;
  watch.start();
  QVERIFY(window_->close());
  window_.reset();
  QVERIFY2(watch.elapsed() < kSoon_ms, qPrintable(QString::number(watch.elapsed())));
  QVERIFY(QFile::exists(path));
}

void DeviceFaultsTest::a_lost_device_is_told_and_tried_again() {
  QVERIFY(change_until_told());
  QVERIFY2(window_->messages().message().contains("the device was lost"),
           qPrintable(window_->messages().message()));
  auto* again = offer("Try Again");
  QVERIFY(again != nullptr);
  again->click();
  QVERIFY(wait_until_done());
  QVERIFY(window_->messages().message().isEmpty());
}

void DeviceFaultsTest::an_export_whose_device_hangs_is_given_up() {
  QVERIFY(wait_until_done());
  const QString path = folder_.filePath("picture.exr");
  QElapsedTimer watch;
  {
    ExportDialog dialog(window_->document(), {});
    dialog.set_quality("draft");
    dialog.set_path(path);
    dialog.begin();
    const auto told = [&] { return !dialog.message().isEmpty(); };
    QVERIFY(QTest::qWaitFor(told, kPatience_ms));
    QVERIFY2(dialog.message().contains("has not answered for 4 s"), qPrintable(dialog.message()));
    QVERIFY(dialog.is_busy());
    watch.start();
    dialog.reject();
    QVERIFY(!dialog.is_busy());
    QVERIFY(dialog.message().contains("given up"));
    dialog.set_path(folder_.filePath("second.exr"));
    QSignalSpy ended(&dialog, &ExportDialog::ended);
    dialog.begin();
    QVERIFY2(watch.elapsed() < kSoon_ms, qPrintable(QString::number(watch.elapsed())));
    QVERIFY(ended.wait(kPatience_ms));
    QVERIFY2(ended.at(0).at(0).toBool(), qPrintable(dialog.message()));
  }
  QVERIFY(!QFile::exists(path));
  QVERIFY(QFile::exists(folder_.filePath("second.exr")));
}

void DeviceFaultsTest::a_film_whose_device_hangs_is_given_up() {
  window_->document().start(small_scene().with({{"/film", R"({"duration_s": 0.3, "fps": 10})"}}),
                            {});
  QVERIFY(wait_until_done());
  const QString first = folder_.filePath("f/1.exr"), second = folder_.filePath("f/2.exr");
  QElapsedTimer watch;
  {
    FilmDialog dialog(window_->document(), {});
    dialog.set_quality("draft");
    dialog.set_path(folder_.filePath("f/#.exr"));
    dialog.begin();
    QVERIFY(QTest::qWaitFor([&] { return !dialog.message().isEmpty(); }, kPatience_ms));
    QVERIFY2(dialog.message().contains("has not answered for 4 s"), qPrintable(dialog.message()));
    QVERIFY(dialog.is_busy());
    QVERIFY2(QFile::exists(first) && !QFile::exists(second),
             qPrintable(QDir(folder_.filePath("f")).entryList().join(' ')));
    watch.start();
    dialog.reject();
    QVERIFY(!dialog.is_busy());
    QVERIFY2(watch.elapsed() < kSoon_ms, qPrintable(QString::number(watch.elapsed())));
    QVERIFY(dialog.message().contains("given up"));
    // The next film goes on from the frame that is there.
    QSignalSpy ended(&dialog, &FilmDialog::ended);
    dialog.begin();
    QVERIFY(ended.wait(kPatience_ms));
    QVERIFY2(ended.at(0).at(0).toBool(), qPrintable(dialog.message()));
    QVERIFY2(dialog.message().contains("2 frames rendered, 1 kept"), qPrintable(dialog.message()));
  }
  QVERIFY(QFile::exists(second));
}

}  // namespace aerostat::viewer

int main(int argc, char** argv) {
  const QApplication application(argc, argv);
  aerostat::viewer::DeviceFaultsTest test;
  const int code = QTest::qExec(&test, argc, argv);
  // The driver's destructors would wait for the calls that hang.
  std::fflush(nullptr);
  std::_Exit(code);
}

#include "device_faults_test.moc"
