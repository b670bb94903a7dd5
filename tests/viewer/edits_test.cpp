// Tests that many edits in the window leave memory, open files and threads as they were.
// AEROSTAT_WINDOW_EDITS=1000 makes more of them than the test does otherwise.
#include <QDir>
#include <QFile>
#include <QtTest>
#include <algorithm>
#include <random>
#include <vector>

#include "scene/scene.hpp"
#include "small_window.hpp"
#include "viewer/main_window.hpp"
#include "viewer/message_bar.hpp"

namespace aerostat::viewer {
namespace {

/// The longest wait in milliseconds. Kernels may have to be compiled first.
constexpr int kPatience_ms = 180000;
constexpr int kEdits = 45;
constexpr const char* kEditsVariable = "AEROSTAT_WINDOW_EDITS";

/// What this process has.
struct Held {
  qint64 memory_kib = 0;
  qsizetype files = 0, threads = 0;
};

Held held() {
  Held now;
  QFile status(QStringLiteral("/proc/self/status"));
  if (!status.open(QIODevice::ReadOnly)) return now;
  for (const QByteArray& line : status.readAll().split('\n')) {
    if (line.startsWith("VmRSS:")) {
      now.memory_kib = line.mid(6).trimmed().split(' ').front().toLongLong();
    }
  }
  const auto count = [](const char* folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot).size();
  };
  now.files = count("/proc/self/fd");
  now.threads = count("/proc/self/task");
  return now;
}

}  // namespace

class EditsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { begin_with_no_settings("aerostat-viewer-edits-test"); }
  void many_edits_leave_memory_flat();
  void the_history_is_bounded();

 private:
  void edit(std::mt19937& random);
  bool wait_until_done();

  std::unique_ptr<MainWindow> window_;
};

/// Makes one edit of those that users make most.
void EditsTest::edit(std::mt19937& random) {
  Document& document = window_->document();
  const int number = static_cast<int>(random() % 1000);
  const QString text = QString::number(number);
  switch (random() % 8) {
    case 0:
      document.set("seed", "/terrain/seed", text);
      break;
    case 1:
      document.set("sun", "/sun/elevation_deg", QString::number(5 + number % 80));
      break;
    case 2:
      document.set("height", "/balloon/position", QString("[0, %1, 0]").arg(100 + number % 300));
      break;
    case 3:
      document.set("clouds", "/sky/cumulus/cover", number % 2 == 0 ? "0.3" : "0");
      break;
    case 4:
      document.set("size", "/image/width", QString::number(96 + number % 128));
      break;
    case 5:
      if (document.undo_stack().canUndo()) document.undo_stack().undo();
      break;
    default:
      window_->camera().look_by(0.02 * (number % 7 - 3), 0.01 * (number % 5 - 2));
  }
}

bool EditsTest::wait_until_done() {
  return QTest::qWaitFor(
      [this] {
        const auto& shown = window_->shown();
        return shown && shown->preview.complete && shown->request == window_->request();
      },
      kPatience_ms);
}

void EditsTest::many_edits_leave_memory_flat() {
  bool is_number = false;
  int edits = qEnvironmentVariableIntValue(kEditsVariable, &is_number);
  if (!is_number || edits < 9) edits = kEdits;
  std::mt19937 random(1);
  window_ = std::make_unique<MainWindow>();
  window_->document().start(small_scene(), {});
  window_->show();
  Held second, last;
  for (int i = 0; i < edits; ++i) {
    edit(random);
    // Every third edit interrupts the render of the one before.
    if (i % 3 != 0) QVERIFY(wait_until_done());
    QVERIFY2(window_->messages().message().isEmpty(), qPrintable(window_->messages().message()));
    const Held now = held();
    Held* const most = 3 * i >= 2 * edits ? &last : 3 * i >= edits ? &second : nullptr;
    if (most == nullptr) continue;
    most->memory_kib = std::max(most->memory_kib, now.memory_kib);
    most->files = std::max(most->files, now.files);
    most->threads = std::max(most->threads, now.threads);
  }
  qInfo("%d edits: %lld and then %lld MiB, %lld and then %lld files, %lld and then %lld threads",
        edits, second.memory_kib / 1024, last.memory_kib / 1024,
        static_cast<long long>(second.files), static_cast<long long>(last.files),
        static_cast<long long>(second.threads), static_cast<long long>(last.threads));
  // Lands of other seeds differ in size. A leak of every edit is far above these bounds.
  QVERIFY(last.memory_kib < second.memory_kib * 5 / 4 + 16 * 1024);
  QVERIFY(last.files <= second.files + 3);
  QVERIFY(last.threads <= second.threads + 3);
}

void EditsTest::the_history_is_bounded() {
  Document document;
  document.start(small_scene(), {});
  const auto make_steps = [&document](int count) {
    const qint64 before = held().memory_kib;
    for (int i = 0; i < count; ++i) {
      document.end_gesture();
      document.set("seed", "/terrain/seed", QString::number(1000 + i % 2));
    }
    return held().memory_kib - before;
  };
  const qint64 first = make_steps(kMostSteps);
  QCOMPARE(document.undo_stack().count(), kMostSteps);
  const qint64 further = make_steps(4 * kMostSteps);
  QCOMPARE(document.undo_stack().count(), kMostSteps);
  qInfo("%d steps take %lld KiB, and four times as many further ones %lld KiB", kMostSteps,
        static_cast<long long>(first), static_cast<long long>(further));
  QVERIFY(further < first + 2048);
  for (int i = 0; i < kMostSteps; ++i) document.undo_stack().undo();
  QVERIFY(!document.undo_stack().canUndo());
}

}  // namespace aerostat::viewer

QTEST_MAIN(aerostat::viewer::EditsTest)
#include "edits_test.moc"
