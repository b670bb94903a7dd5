// Tests the window with small scenes: rapid changes, latencies, errors, export and closing.
#include <QAbstractButton>
#include <QClipboard>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <atomic>

#include "opencl/status.hpp"
#include "scene/scene.hpp"
#include "small_window.hpp"
#include "viewer/export_dialog.hpp"
#include "viewer/main_window.hpp"
#include "viewer/message_bar.hpp"
#include "viewer/panels.hpp"
#include "viewer/picture_view.hpp"
#include "viewer/scene_presets.hpp"

namespace aerostat::viewer {
namespace {

/// The longest wait in milliseconds. Kernels may have to be compiled first.
constexpr int kPatience_ms = 180000;
/// Bounds in milliseconds for machines that are busy with something else. The measured times are
/// printed.
constexpr qint64 kFirstLook_ms = 1000;
constexpr qint64 kCancel_ms = 3000;

}  // namespace

class WindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void init();
  void cleanup() { window_.reset(); }
  void shows_the_scene_to_the_end();
  void shows_clouds();
  void a_change_is_seen_soon();
  void two_hundred_changes_leave_the_last();
  void the_mouse_moves_the_camera();
  void a_click_puts_the_balloon();
  void the_menu_has_the_cameras_of_the_scenes();
  void a_device_that_is_none_offers_another();
  void a_lost_device_offers_another_data();
  void a_lost_device_offers_another();
  void copies_the_picture();
  void exports_and_cancels();
  void asks_before_changes_are_lost();
  void opens_what_is_dropped();
  void closes_while_it_renders();

 private:
  bool wait_until_done();
  /// Returns the button in the message bar whose text contains `text`, or null if there is none.
  static QAbstractButton* offer(MainWindow& window, const QString& text);

  std::unique_ptr<MainWindow> window_;
  QTemporaryDir folder_;
};

void WindowTest::initTestCase() {
  qputenv("AEROSTAT_SCENE_DIR", AEROSTAT_SOURCE_DIR "/scenes");
  begin_with_no_settings("aerostat-viewer-test");
}

void WindowTest::init() {
  window_ = std::make_unique<MainWindow>();
  window_->document().start(small_scene(), {});
  window_->show();
}

bool WindowTest::wait_until_done() {
  return QTest::qWaitFor(
      [this] {
        const auto& shown = window_->shown();
        return shown && shown->preview.complete && shown->request == window_->request();
      },
      kPatience_ms);
}

void WindowTest::shows_the_scene_to_the_end() {
  QVERIFY(wait_until_done());
  QCOMPARE(window_->shown()->image.size(), QSize(160, 90));
  QCOMPARE(window_->shown()->preview.samples, 4);
  QCOMPARE(window_->view().image(), window_->shown()->image);
  QVERIFY(window_->messages().message().isEmpty());
  // The picture does not have the same colour everywhere.
  const QImage& image = window_->shown()->image;
  QVERIFY(image.pixel(80, 2) != image.pixel(80, 85));
}

void WindowTest::shows_clouds() {
  const auto scene = small_scene("snow").with({{"/sky/cumulus/cover", "0.3"}});
  window_->document().start(scene, {});
  QVERIFY(wait_until_done());
  QVERIFY(window_->messages().message().isEmpty());
}

void WindowTest::a_change_is_seen_soon() {
  QVERIFY(wait_until_done());
  QElapsedTimer watch;
  for (const char* view : {"first", "second", "third"}) {
    watch.start();
    window_->camera().look_by(0.05, 0.0);
    const auto request = window_->request();
    QVERIFY(QTest::qWaitFor([&] { return window_->shown()->request == request; }, kPatience_ms));
    qInfo("%s preview after a turn of the view: %lld ms", view, watch.elapsed());
    QVERIFY(watch.elapsed() < kFirstLook_ms);
  }
}

void WindowTest::two_hundred_changes_leave_the_last() {
  QVERIFY(wait_until_done());
  QElapsedTimer watch, turn;
  watch.start();
  qint64 slowest = 0;
  for (int i = 0; i < 200; ++i) {
    turn.start();
    window_->camera().look_by(0.002 * (i % 7 - 3), 0.0);
    window_->document().set("seed", "/terrain/seed", QString::number(i / 20 + 1));
    QCoreApplication::processEvents();
    slowest = std::max(slowest, turn.elapsed());
    QTest::qWait(std::max<int>(0, 25 * (i + 1) - static_cast<int>(watch.elapsed())));
  }
  qInfo("200 changes in %lld ms; the window was busy with one for %lld ms at most", watch.elapsed(),
        slowest);
  QVERIFY(wait_until_done());
  const auto& seen = window_->shown()->preview.scene;
  QCOMPARE(seen->terrain.seed, 10u);
  QCOMPARE(seen.target().x, window_->document().scene().camera.target->x);
}

void WindowTest::the_mouse_moves_the_camera() {
  QVERIFY(wait_until_done());
  QWidget* view = window_->view().viewport();
  const auto before = *window_->camera().pose();
  const QPoint middle = view->rect().center();
  QTest::mousePress(view, Qt::LeftButton, {}, middle);
  QTest::mouseMove(view, middle + QPoint(40, 0));
  QMouseEvent move(QEvent::MouseMove, middle + QPoint(40, 0), view->mapToGlobal(middle),
                   Qt::NoButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(view, &move);
  QTest::mouseRelease(view, Qt::LeftButton, {}, middle + QPoint(40, 0));
  const auto turned = *window_->camera().pose();
  QVERIFY(glm::distance(turned.position, before.position) > 1.0);
  QVERIFY(glm::distance(turned.target, before.target) < 0.1);
  QCOMPARE(window_->camera().kind(), ViewKind::free);
  QTest::keyPress(&window_->view(), Qt::Key_W);
  QTest::qWait(200);
  QTest::keyRelease(&window_->view(), Qt::Key_W);
  QVERIFY(glm::distance(window_->camera().pose()->position, turned.position) > 0.5);
  QVERIFY(wait_until_done());
}

void WindowTest::a_click_puts_the_balloon() {
  QVERIFY(wait_until_done());
  const auto eye = *window_->camera().pose();
  window_->camera().put_balloon({0.2, 0.9});
  QVERIFY(window_->document().scene().balloon.position.z != 0.0);
  QVERIFY(wait_until_done());
  QVERIFY(glm::distance(window_->camera().pose()->position, eye.position) < 0.1);
  // A double click on an object moves it to the middle of the picture.
  const auto& film = window_->shown()->preview.film;
  std::size_t hit = 0;
  while (hit < film.object_id.size() && film.object_id[hit] != 3u) ++hit;
  // The object is out of sight.
  if (hit == film.object_id.size()) return;
  const QPointF place((static_cast<double>(hit % 160) + 0.5) / 160,
                      (static_cast<double>(hit / 160) + 0.5) / 90);
  window_->camera().aim_at(place);
  QVERIFY(wait_until_done());
  QCOMPARE(window_->shown()->preview.film.object_id[45 * 160 + 80], 3u);
}

void WindowTest::the_menu_has_the_cameras_of_the_scenes() {
  QMenu* menu = nullptr;
  for (const QAction* action : window_->menuBar()->actions()) {
    if (action->text() == "&Camera") menu = action->menu();
  }
  QVERIFY(menu != nullptr);
  const auto entry = [&](const QString& text) -> QAction* {
    Q_EMIT menu->aboutToShow();
    for (QAction* action : menu->actions()) {
      if (action->text() == text) return action;
    }
    return nullptr;
  };
  const auto size = [&] {
    Q_EMIT menu->aboutToShow();
    return menu->actions().size();
  };
  const auto of_sand = scene_presets(scene::BiomeKind::sand);
  QVERIFY(!of_sand.empty());
  QCOMPARE(entry("snow"), nullptr);
  for (const ScenePreset& preset : of_sand) {
    QAction* action = entry(preset.name);
    QVERIFY2(action != nullptr, qPrintable(preset.name));
    action->trigger();
    const auto& camera = window_->document().scene().camera;
    QCOMPARE(camera.fov_y_deg, preset.scene.scene().camera.fov_y_deg);
    QVERIFY(camera.position == preset.scene.scene().camera.position);
  }
  const auto entries = size();
  QCOMPARE(size(), entries);
  entry("As in the file")->trigger();
  QVERIFY(window_->document().scene().camera.position == small_scene().scene().camera.position);
  QVERIFY(window_->document().set("biome", "/biome/kind", "\"snow\""));
  QVERIFY(entry("snow") != nullptr);
  QCOMPARE(entry("sand"), nullptr);
}

QAbstractButton* WindowTest::offer(MainWindow& window, const QString& text) {
  for (auto* button : window.messages().findChildren<QAbstractButton*>()) {
    if (button->isVisible() && button->text().contains(text)) return button;
  }
  return nullptr;
}

void WindowTest::a_device_that_is_none_offers_another() {
  QVERIFY(wait_until_done());
  MainWindow lost(QStringLiteral("no-such-device"));
  lost.show();
  QVERIFY(QTest::qWaitFor([&] { return !lost.messages().message().isEmpty(); }, kPatience_ms));
  QVERIFY(lost.messages().message().contains("no-such-device"));
  QAbstractButton* automatic = offer(lost, "Automatic");
  QVERIFY(automatic != nullptr);
  lost.document().start(small_scene(), {});
  automatic->click();
  QVERIFY(QTest::qWaitFor([&] { return lost.shown() != nullptr; }, kPatience_ms));
}

void WindowTest::a_lost_device_offers_another_data() {
  QTest::addColumn<QString>("device");
  QTest::addColumn<QString>("taken");
  QTest::newRow("the automatic one") << "0:0"
                                     << "Automatic";
  QTest::newRow("one by its name") << ""
                                   << "Use ";
  QTest::newRow("the same again") << "0:0"
                                  << "Try Again";
}

void WindowTest::a_lost_device_offers_another() {
  QFETCH(QString, device);
  QFETCH(QString, taken);
  window_.reset();
  QSettings().remove("device");
  std::atomic<bool> is_lost = false;
  render::TestHooks hooks;
  hooks.before_launch = [&](const opencl::Device&) {
    if (is_lost) {
      opencl::rethrow("starting the kernel trace_camera_rays",
                      cl::Error(CL_DEVICE_NOT_AVAILABLE, "clEnqueueNDRangeKernel"));
    }
  };
  // The render is so long that the device is lost in the middle of it.
  MainWindow window(device, hooks);
  window.document().start(
      small_scene().with(
          {{"/image/width", "2000"}, {"/image/height", "2000"}, {"/image/spp", "256"}}),
      {});
  window.show();
  const auto told = [&] { return window.messages().message(); };
  QVERIFY(QTest::qWaitFor([&] { return window.shown() != nullptr; }, kPatience_ms));
  QVERIFY(!window.shown()->preview.complete);
  is_lost = true;
  QVERIFY(QTest::qWaitFor([&] { return !told().isEmpty(); }, kPatience_ms));
  QVERIFY2(told().contains("the device was lost"), qPrintable(told()));
  QVERIFY(!window.view().image().isNull());

  // The window still takes changes, and reports again what prevents the picture.
  window.messages().dismiss();
  QElapsedTimer watch;
  watch.start();
  window.camera().look_by(0.05, 0.0);
  QCoreApplication::processEvents();
  QVERIFY(watch.elapsed() < kFirstLook_ms);
  QVERIFY(QTest::qWaitFor([&] { return !told().isEmpty(); }, kPatience_ms));
  QVERIFY(window.shown()->request < window.request());

  is_lost = false;
  QAbstractButton* other = offer(window, taken);
  QVERIFY2(other != nullptr, qPrintable(taken));
  other->click();
  QVERIFY(told().isEmpty());
  QVERIFY(
      QTest::qWaitFor([&] { return window.shown()->request == window.request(); }, kPatience_ms));
  QVERIFY2(told().isEmpty(), qPrintable(told()));
  QSettings().remove("device");
}

void WindowTest::copies_the_picture() {
  QVERIFY(wait_until_done());
  for (auto* action : window_->findChildren<QAction*>()) {
    if (action->shortcut() == QKeySequence("Ctrl+Shift+C")) action->trigger();
  }
  QCOMPARE(QGuiApplication::clipboard()->image().size(), QSize(160, 90));
}

void WindowTest::exports_and_cancels() {
  ExportDialog dialog(window_->document(), {});
  dialog.set_quality("draft");
  dialog.set_path(folder_.filePath("picture.png"));
  QSignalSpy ended(&dialog, &ExportDialog::ended);
  dialog.begin();
  QVERIFY(ended.wait(kPatience_ms));
  QVERIFY2(ended.at(0).at(0).toBool(), qPrintable(dialog.message()));
  QCOMPARE(QImage(folder_.filePath("picture.png")).size(), QSize(160, 90));

  window_->document().change("size", {{"/image/width", "4000"}, {"/image/height", "3000"}});
  ExportDialog large(window_->document(), {});
  large.set_quality("final");
  large.set_path(folder_.filePath("never.exr"));
  QSignalSpy cancelled(&large, &ExportDialog::ended);
  large.begin();
  QTest::qWait(500);
  QVERIFY(large.is_busy());
  QElapsedTimer watch;
  watch.start();
  large.reject();
  QVERIFY(cancelled.wait(kPatience_ms));
  qInfo("an export was cancelled after %lld ms", watch.elapsed());
  QVERIFY(watch.elapsed() < kCancel_ms);
  QVERIFY(!QFile::exists(folder_.filePath("never.exr")));
}

void WindowTest::asks_before_changes_are_lost() {
  QVERIFY(window_->document().set("seed", "/terrain/seed", "5"));
  QVERIFY(window_->isWindowModified());
  const auto answer_with = [](QMessageBox::StandardButton button) {
    QTimer::singleShot(200, [button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box != nullptr) box->button(button)->click();
    });
  };
  answer_with(QMessageBox::Cancel);
  QVERIFY(!window_->close());
  QVERIFY(window_->isVisible());
  answer_with(QMessageBox::Discard);
  QVERIFY(window_->close());
}

void WindowTest::opens_what_is_dropped() {
  const QString path = QStringLiteral(AEROSTAT_SOURCE_DIR "/scenes/tropical.json");
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &enter);
  QVERIFY(enter.isAccepted());
  QDropEvent drop(QPointF(9, 9), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &drop);
  QCOMPARE(window_->document().path(), path);
  QCOMPARE(window_->document().scene().biome.kind, scene::BiomeKind::tropical);
  QVERIFY(window_->windowTitle().contains("tropical.json"));
  QVERIFY(QSettings().value("recent").toStringList().contains(path));
}

void WindowTest::closes_while_it_renders() {
  window_->document().start(
      small_scene("snow").with({{"/image/width", "2000"}, {"/image/height", "2000"}}), {});
  QVERIFY(QTest::qWaitFor([&] { return window_->shown() != nullptr; }, kPatience_ms));
  window_->camera().look_by(0.1, 0.0);
  QTest::qWait(300);
  // Without this, the window would ask what to do with the change.
  window_->document().undo_stack().setClean();
  QElapsedTimer watch;
  watch.start();
  QVERIFY(window_->close());
  window_.reset();
  qInfo("closed while rendering after %lld ms", watch.elapsed());
  QVERIFY(watch.elapsed() < kCancel_ms);
}

}  // namespace aerostat::viewer

QTEST_MAIN(aerostat::viewer::WindowTest)
#include "window_test.moc"
