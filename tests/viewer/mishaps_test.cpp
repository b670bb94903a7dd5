// Tests faults around the window: files that are not scenes, full disks, and exports that end
// early.
#include <QDropEvent>
#include <QElapsedTimer>
#include <QMimeData>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QtTest>
#include <csignal>

#include <sys/resource.h>
#include <sys/stat.h>

#include "scene/scene.hpp"
#include "small_window.hpp"
#include "viewer/export_dialog.hpp"
#include "viewer/main_window.hpp"
#include "viewer/message_bar.hpp"

namespace aerostat::viewer {
namespace {

/// The longest wait in milliseconds. Kernels may have to be compiled first.
constexpr int kPatience_ms = 180000;
/// A bound in milliseconds that also holds on a machine that is busy with something else.
constexpr qint64 kSoon_ms = 5000;

QByteArray bytes_of(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  QCOMPARE(file.write(bytes), bytes.size());
}

/// Keeps files from growing beyond a size while the object lives. As on a full disk, a write ends
/// half-way.
class NoRoom {
 public:
  explicit NoRoom(rlim_t most) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{most, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  NoRoom(const NoRoom&) = delete;
  NoRoom& operator=(const NoRoom&) = delete;
  ~NoRoom() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

}  // namespace

class MishapsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void init();
  void cleanup() { window_.reset(); }
  void no_scenes_are_dropped_data();
  void no_scenes_are_dropped();
  void a_balloon_beyond_all_heights_is_told();
  void a_pipe_is_not_taken();
  void without_room_the_saved_file_stays();
  void an_export_that_cannot_be_written_tells_why_data();
  void an_export_that_cannot_be_written_tells_why();
  void sizes_of_exports_data();
  void sizes_of_exports();
  void an_export_closed_half_way_leaves_the_older_picture();
  void undo_does_not_reach_an_export();
  void a_device_of_the_environment_that_is_none();

 private:
  /// Returns whether the window accepts a dropped file.
  bool drop(const QString& path);
  QString path(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }

  std::unique_ptr<MainWindow> window_;
  QTemporaryDir folder_;
};

void MishapsTest::initTestCase() {
  begin_with_no_settings("aerostat-viewer-mishaps-test");
}

void MishapsTest::init() {
  window_ = std::make_unique<MainWindow>();
  window_->document().start(small_scene(), {});
  window_->show();
}

bool MishapsTest::drop(const QString& path) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  enter.ignore();
  QCoreApplication::sendEvent(window_.get(), &enter);
  if (!enter.isAccepted()) return false;
  QDropEvent drop(QPointF(9, 9), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &drop);
  return true;
}

void MishapsTest::no_scenes_are_dropped_data() {
  QTest::addColumn<QString>("path");
  QTest::addColumn<QString>("message");
  const QByteArray many(8 << 20, 'A');
  put(path("empty.json"), {});
  put(path("key.json"), "{\"version\": 1, \"" + many + "\": 1}");
  put(path("deep.json"), QByteArray(8 << 20, '['));
  put(path("markup.json"), "{\"version\": 1, \"<h1>quality\": 1}");
  QFile huge(path("huge.json"));
  QVERIFY(huge.open(QIODevice::WriteOnly));
  for (int i = 0; i < 25; ++i) QCOMPARE(huge.write(many), many.size());
  QTest::newRow("folder") << folder_.path() << "folder";
  QTest::newRow("empty") << path("empty.json") << "line 1";
  QTest::newRow("200 MB of text") << path("huge.json") << "16 MiB";
  QTest::newRow("a key of 8 MB") << path("key.json") << "AAAA";
  QTest::newRow("deep") << path("deep.json") << "nesting";
  QTest::newRow("markup") << path("markup.json") << "<h1>quality";
}

void MishapsTest::no_scenes_are_dropped() {
  QFETCH(QString, path);
  QFETCH(QString, message);
  const std::string before = window_->document().source().text();
  QElapsedTimer watch;
  watch.start();
  QVERIFY(drop(path));
  window_->grab();
  QVERIFY2(watch.elapsed() < kSoon_ms, qPrintable(QString::number(watch.elapsed())));
  const QString told = window_->messages().message();
  QVERIFY2(told.contains(message), qPrintable(told));
  QVERIFY(told.size() < 1000);
  QCOMPARE(window_->document().source().text(), before);
  QVERIFY(window_->document().path().isEmpty());
  QVERIFY(window_->minimumSizeHint().width() < 1200);
}

/// Tests a fault that only the render can find. It is reported, and the window goes on.
void MishapsTest::a_balloon_beyond_all_heights_is_told() {
  scene::SceneSource source = small_scene().with({{"/terrain/base_m", "500"}});
  window_->document().start(source.with({{"/balloon/position", "[0, 1000000, 0]"}}), {});
  const auto told = [this] {
    return window_->messages().message().contains("/balloon/position/1");
  };
  QVERIFY(QTest::qWaitFor(told, kPatience_ms));
  QVERIFY(window_->document().set("height", "/balloon/position", "[0, 100, 0]"));
  const auto shown = [this] {
    return window_->shown() && window_->shown()->request == window_->request();
  };
  QVERIFY(QTest::qWaitFor(shown, kPatience_ms));
}

void MishapsTest::a_pipe_is_not_taken() {
  QCOMPARE(mkfifo(qPrintable(path("pipe.json")), 0600), 0);
  QVERIFY(!drop(path("pipe.json")));
}

void MishapsTest::without_room_the_saved_file_stays() {
  // The window is closed first, because its kernels are written to files as well.
  window_.reset();
  Document document;
  QSignalSpy failed(&document, &Document::failed);
  QVERIFY(document.save(path("saved.json")));
  const QByteArray before = bytes_of(path("saved.json"));
  QVERIFY(document.set("seed", "/terrain/seed", "5"));
  {
    const NoRoom no_room(16);
    QVERIFY(!document.save(path("saved.json")));
  }
  QCOMPARE(failed.count(), 1);
  QVERIFY(failed.at(0).at(0).toString().contains("cannot write"));
  QVERIFY(document.is_modified());
  QCOMPARE(bytes_of(path("saved.json")), before);
  QCOMPARE(QDir(folder_.path()).entryList({".aerostat*"}, QDir::Files | QDir::Hidden).size(), 0);
  QVERIFY(document.save(path("saved.json")));
  QVERIFY(bytes_of(path("saved.json")) != before);
}

void MishapsTest::an_export_that_cannot_be_written_tells_why_data() {
  QTest::addColumn<QString>("path");
  QTest::newRow("folder") << folder_.path() + "/";
  QTest::newRow("no such folder") << path("none/picture.png");
  QTest::newRow("read-only") << "/proc/picture.png";
  QVERIFY(QFile::link("/dev/full", path("full.png")));
  QTest::newRow("full") << path("full.png");
}

void MishapsTest::an_export_that_cannot_be_written_tells_why() {
  QFETCH(QString, path);
  ExportDialog dialog(window_->document(), {});
  dialog.set_quality("draft");
  dialog.set_path(path);
  QSignalSpy ended(&dialog, &ExportDialog::ended);
  dialog.begin();
  QVERIFY(ended.wait(kPatience_ms));
  QVERIFY(!ended.at(0).at(0).toBool());
  QVERIFY2(dialog.message().contains("cannot write"), qPrintable(dialog.message()));
  QVERIFY(!dialog.is_busy());
}

void MishapsTest::sizes_of_exports_data() {
  QTest::addColumn<int>("side");
  QTest::newRow("1") << 1;
  QTest::newRow("20000") << 20000;
  QTest::newRow("the largest") << 0;
}

/// Tests the sizes of exports. Small ones are completed, and large ones can be begun and cancelled.
void MishapsTest::sizes_of_exports() {
  QFETCH(int, side);
  ExportDialog dialog(window_->document(), {});
  for (auto* box : dialog.findChildren<QSpinBox*>()) {
    box->setValue(side == 0 ? box->maximum() : side);
  }
  dialog.set_quality("draft");
  dialog.set_path(path("side.png"));
  QSignalSpy ended(&dialog, &ExportDialog::ended);
  dialog.begin();
  if (side == 1) {
    QVERIFY(ended.wait(kPatience_ms));
    QVERIFY2(ended.at(0).at(0).toBool(), qPrintable(dialog.message()));
    QCOMPARE(QImage(path("side.png")).size(), QSize(1, 1));
    QVERIFY(QFile::remove(path("side.png")));
    return;
  }
  QTest::qWait(1000);
  if (dialog.is_busy()) {
    dialog.reject();
    QVERIFY(ended.wait(kPatience_ms));
  }
  qInfo("%s", qPrintable(dialog.message()));
  QVERIFY(!dialog.message().isEmpty());
  QVERIFY(!QFile::exists(path("side.png")));
}

void MishapsTest::an_export_closed_half_way_leaves_the_older_picture() {
  put(path("older.png"), "older");
  window_->document().change("size", {{"/image/width", "4000"}, {"/image/height", "3000"}});
  QElapsedTimer watch;
  {
    ExportDialog dialog(window_->document(), {});
    dialog.set_quality("final");
    dialog.set_path(path("older.png"));
    dialog.show();
    dialog.begin();
    QTest::qWait(500);
    QVERIFY(dialog.is_busy());
    for (auto* button : dialog.findChildren<QPushButton*>()) {
      QCOMPARE(button->isEnabled(), button->text() == "Cancel");
    }
    watch.start();
    dialog.close();
  }
  QVERIFY(watch.elapsed() < kSoon_ms);
  QCOMPARE(bytes_of(path("older.png")), QByteArray("older"));
}

void MishapsTest::undo_does_not_reach_an_export() {
  Document& document = window_->document();
  document.change("size", {{"/image/width", "200"}, {"/image/height", "100"}});
  ExportDialog dialog(document, {});
  dialog.set_quality("draft");
  dialog.set_path(path("undone.png"));
  QSignalSpy ended(&dialog, &ExportDialog::ended);
  dialog.begin();
  document.undo_stack().undo();
  QVERIFY(ended.wait(kPatience_ms));
  QVERIFY2(ended.at(0).at(0).toBool(), qPrintable(dialog.message()));
  QCOMPARE(QImage(path("undone.png")).size(), QSize(200, 100));
  QCOMPARE(document.scene().image.width, 160);
}

void MishapsTest::a_device_of_the_environment_that_is_none() {
  window_.reset();
  qputenv("AEROSTAT_DEVICE", "9:9");
  window_ = std::make_unique<MainWindow>();
  window_->show();
  const bool told =
      QTest::qWaitFor([&] { return !window_->messages().message().isEmpty(); }, kPatience_ms);
  qunsetenv("AEROSTAT_DEVICE");
  QVERIFY(told);
  QVERIFY2(window_->messages().message().contains("9:9"),
           qPrintable(window_->messages().message()));
}

}  // namespace aerostat::viewer

QTEST_MAIN(aerostat::viewer::MishapsTest)
#include "mishaps_test.moc"
