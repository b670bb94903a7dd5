#include "viewer/main_window.hpp"

#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QSettings>
#include <QVBoxLayout>
#include <utility>

#include "viewer/command_text.hpp"
#include "viewer/export_dialog.hpp"
#include "viewer/film_dialog.hpp"
#include "viewer/message_bar.hpp"
#include "viewer/panels.hpp"
#include "viewer/picture_view.hpp"
#include "viewer/scene_files.hpp"
#include "viewer/screen_fit.hpp"
#include "viewer/timeline_panel.hpp"

namespace aerostat::viewer {

MainWindow::MainWindow(const QString& device, render::TestHooks hooks, QWidget* parent)
    : QMainWindow(parent),
      camera_(document_),
      models_(document_),
      device_(device),
      hooks_(std::move(hooks)) {
  if (device_.isEmpty()) device_ = QSettings().value(QStringLiteral("device")).toString();
  setObjectName(QStringLiteral("main"));
  setAcceptDrops(true);
  build();
  connect_view();
  connect_models();
  add_file_menu();
  add_edit_menu();
  add_view_menu();
  add_camera_menu();
  add_help_menu();
  start_renderer();
  panels_->show_device(device_);
  connect(&document_, &Document::changed, this, &MainWindow::render);
  connect(&document_, &Document::failed, this,
          [this](const QString& message) { messages_->show_message(message); });
  connect(&document_, &Document::saved_with, this,
          [this](const QString& message) { messages_->show_message(message); });
  connect(&document_, &Document::file_changed, this, &MainWindow::show_title);
  connect(files_, &SceneFiles::changed_elsewhere, this, &MainWindow::show_changed_file);
  connect(&document_.undo_stack(), &QUndoStack::cleanChanged, this, &MainWindow::show_title);
  restore_layout();
  show_title();
  render();
}

MainWindow::~MainWindow() {
  // The docks are hidden when the members of this class are gone already.
  findChild<QDockWidget*>(QStringLiteral("timeline"))->toggleViewAction()->disconnect(this);
  timeline_->disconnect(this);
}

void MainWindow::build() {
  view_ = new PictureView;
  messages_ = new MessageBar;
  files_ = new SceneFiles(document_, this);
  panels_ = new Panels(document_, camera_);
  auto* middle = new QWidget;
  auto* layout = new QVBoxLayout(middle);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(messages_);
  layout->addWidget(view_, 1);
  setCentralWidget(middle);
  auto* dock = new QDockWidget(tr("Controls"));
  dock->setObjectName(QStringLiteral("controls"));
  dock->setWidget(panels_);
  addDockWidget(Qt::RightDockWidgetArea, dock);
  add_timeline();
  build_status();
  view_->setFocus();
}

void MainWindow::add_timeline() {
  timeline_ = new TimelinePanel(document_);
  auto* dock = new QDockWidget(tr("Timeline"));
  dock->setObjectName(QStringLiteral("timeline"));
  dock->setWidget(timeline_);
  dock->hide();
  addDockWidget(Qt::BottomDockWidgetArea, dock);
  connect(timeline_, &TimelinePanel::time_changed, this, &MainWindow::render);
  connect(timeline_, &TimelinePanel::export_asked, this, &MainWindow::export_film);
  // Without its timeline, the window shows the still picture.
  connect(dock->toggleViewAction(), &QAction::toggled, this, [this](bool is_open) {
    if (!is_open && isVisible()) timeline_->show_still();
  });
  connect(&document_, &Document::file_changed, this, &MainWindow::show_timeline_of_films);
}

/// Opens the timeline for a scene that says something of a film.
void MainWindow::show_timeline_of_films() {
  auto* dock = findChild<QDockWidget*>(QStringLiteral("timeline"));
  if (document_.source().gives("/film")) dock->show();
}

void MainWindow::connect_view() {
  connect(view_, &PictureView::orbited, &camera_, &CameraControl::orbit_by);
  connect(view_, &PictureView::looked, &camera_, &CameraControl::look_by);
  connect(view_, &PictureView::dollied, &camera_, &CameraControl::dolly_by);
  connect(view_, &PictureView::flown, &camera_, &CameraControl::fly_by);
  connect(view_, &PictureView::aimed, &camera_, &CameraControl::aim_at);
  connect(view_, &PictureView::gesture_ended, &document_, &Document::end_gesture);
  connect(view_, &PictureView::placed, this, [this](const QPointF& place) {
    camera_.put_balloon(place, panels_->balloons().chosen());
    view_->set_placing(false);
  });
  connect(panels_, &Panels::placing_asked, this, [this] {
    view_->set_placing(true);
    view_->setFocus();
  });
  connect(panels_, &Panels::device_chosen, this, &MainWindow::choose_device);
}

void MainWindow::start_renderer() {
  RenderThread::Listener listener;
  listener.shown = [this](std::shared_ptr<const Shown> shown) { show_look(std::move(shown)); };
  listener.progressed = [this](const render::Progress& progress) { show_progress(progress); };
  listener.troubled = [this](const Trouble& trouble) { show_trouble(trouble); };
  listener.devices_found = [this](const std::vector<DeviceChoice>& devices) {
    devices_ = devices;
    panels_->show_devices(devices);
  };
  listener.answered = [this] {
    if (std::exchange(device_hangs_, false)) messages_->dismiss();
  };
  renderer_ = RenderThread::start(std::move(listener), hooks_);
  if (!device_.isEmpty()) renderer_->use_device(device_);
}

/// Replaces a thread whose device hangs by a new one.
void MainWindow::renew_renderer() {
  if (!std::exchange(device_hangs_, false)) return;
  renderer_.reset();
  start_renderer();
}

void MainWindow::render() {
  const auto time = timeline_->shown_time();
  request_ =
      time ? renderer_->render(document_.source(), *time) : renderer_->render(document_.scene());
}

void MainWindow::choose_device(const QString& selector) {
  device_ = selector;
  QSettings().setValue(QStringLiteral("device"), selector);
  messages_->dismiss();
  panels_->show_device(selector);
  renew_renderer();
  renderer_->use_device(selector);
  render();
}

void MainWindow::show_changed_file(const QString& message, bool can_reload) {
  std::vector<MessageBar::Offer> offers;
  if (can_reload) {
    const QString text = document_.is_modified() ? tr("Reload and Lose Changes") : tr("Reload");
    offers.push_back({text, [this] { files_->reload(); }});
  }
  messages_->show_message(message, offers);
}

void MainWindow::show_trouble(const Trouble& trouble) {
  if (trouble.request != 0 && trouble.request < request_ && trouble.kind == ErrorKind::bad_data) {
    return;  // The trouble belongs to a scene that was changed in the meantime.
  }
  device_hangs_ = trouble.hangs;
  std::vector<MessageBar::Offer> offers;
  if (trouble.kind != ErrorKind::bad_data) {
    offers.push_back({tr("Try Again"), [this] {
                        renew_renderer();
                        render();
                      }});
    if (!device_.isEmpty()) {
      offers.push_back({tr("Use the Automatic Device"), [this] { choose_device({}); }});
    }
    for (const DeviceChoice& device : devices_) {
      if (device.selector == device_) continue;
      offers.push_back({tr("Use %1").arg(device.name),
                        [this, selector = device.selector] { choose_device(selector); }});
      if (offers.size() >= 4) break;
    }
  }
  messages_->show_message(trouble.message, offers);
  show_progress({});
}

bool MainWindow::open(const QString& path) {
  return files_->open(path);
}

void MainWindow::export_picture() {
  renderer_->pause();
  ExportDialog dialog(document_, device_, this);
  dialog.exec();
  render();
}

void MainWindow::export_film() {
  timeline_->pause();
  renderer_->pause();
  FilmDialog dialog(document_, device_, this);
  dialog.exec();
  render();
}

void MainWindow::copy_picture() {
  if (shown_) QApplication::clipboard()->setImage(shown_->image);
}

void MainWindow::copy_command() {
  QApplication::clipboard()->setText(command_text(document_, device_));
}

void MainWindow::show_title() {
  const QString name =
      document_.path().isEmpty() ? tr("Unnamed scene") : QFileInfo(document_.path()).fileName();
  setWindowTitle(tr("%1[*] — Aerostat").arg(name));
  setWindowModified(document_.is_modified());
  setWindowFilePath(document_.path());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  take_typed();
  if (!files_->may_discard()) {
    event->ignore();
    return;
  }
  save_layout();
  renderer_->pause();
  event->accept();
}

void MainWindow::save_layout() {
  QSettings settings;
  settings.setValue(QStringLiteral("geometry"), saveGeometry());
  settings.setValue(QStringLiteral("state"), saveState());
}

void MainWindow::restore_layout() {
  const QSettings settings;
  if (restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray())) {
    move_onto_screen(*this);
  } else {
    resize_to_fit(*this, QSize(1280, 800));
  }
  restoreState(settings.value(QStringLiteral("state")).toByteArray());
}

}  // namespace aerostat::viewer
