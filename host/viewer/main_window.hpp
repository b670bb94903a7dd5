#pragma once

#include <QMainWindow>
#include <memory>

#include "viewer/camera_control.hpp"
#include "viewer/document.hpp"
#include "viewer/model_control.hpp"
#include "viewer/render_thread.hpp"

class QLabel;

namespace aerostat::viewer {

class MessageBar;
class Panels;
class PictureView;
class SceneFiles;
class TimelinePanel;

/// The main window with the picture, the panels beside it, the menus, and a line that shows the
/// progress of the picture.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// Makes the window. `device` is a selector as that of `--device`, or empty for the device that
  /// was chosen last. Only tests give hooks.
  explicit MainWindow(const QString& device = {}, render::TestHooks hooks = {},
                      QWidget* parent = nullptr);
  ~MainWindow() override;

  Document& document() { return document_; }
  CameraControl& camera() { return camera_; }
  ModelControl& models() { return models_; }
  Panels& panels() { return *panels_; }
  PictureView& view() { return *view_; }
  MessageBar& messages() { return *messages_; }
  TimelinePanel& timeline() { return *timeline_; }
  /// Returns the preview that is shown, or null before the first one.
  const std::shared_ptr<const Shown>& shown() const { return shown_; }
  /// Returns the number of the render that shows the present document.
  std::uint64_t request() const { return request_; }

  bool open(const QString& path);
  /// Takes a file that was dropped on the window at a place of the picture, or beside the picture
  /// if there is no place. A model is put there, a picture on an envelope becomes its artwork, and
  /// any other file is opened.
  void take_file(const QString& path, const std::optional<QPointF>& place);

 Q_SIGNALS:
  void look_arrived();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void build();
  void build_status();
  void connect_view();
  void connect_models();
  void put_artwork(const QString& path, const std::optional<QPointF>& place);
  void offer_wraps(const QString& name, const QString& pointer);
  void ask_for_model();
  void show_mark();
  void add_file_menu();
  void add_edit_menu();
  void add_view_menu();
  void add_camera_menu();
  void list_scene_cameras(class QMenu* menu, QAction* end);
  void add_help_menu();
  QAction* add_action(class QMenu* menu, const QString& text, const QKeySequence& keys,
                      const std::function<void()>& act);

  void take_typed();
  void start_renderer();
  void renew_renderer();
  void render();
  void show_look(std::shared_ptr<const Shown> shown);
  void show_progress(const render::Progress& progress);
  void show_changed_file(const QString& message, bool can_reload);
  void show_trouble(const Trouble& trouble);
  void choose_device(const QString& selector);
  void show_title();
  void export_picture();
  void export_film();
  void add_timeline();
  void show_timeline_of_films();
  void copy_picture();
  void copy_command();
  void save_layout();
  void restore_layout();

  Document document_;
  CameraControl camera_;
  ModelControl models_;
  Panels* panels_ = nullptr;
  PictureView* view_ = nullptr;
  MessageBar* messages_ = nullptr;
  SceneFiles* files_ = nullptr;
  TimelinePanel* timeline_ = nullptr;
  /// The cameras of the installed scenes in the menu when it was shown last.
  std::vector<QAction*> scene_cameras_;
  QLabel* device_label_ = nullptr;
  QLabel* work_label_ = nullptr;
  QLabel* place_label_ = nullptr;
  QString device_;
  std::vector<DeviceChoice> devices_;
  std::shared_ptr<const Shown> shown_;
  std::uint64_t request_ = 0;
  /// Tells whether the device of the thread does not answer.
  bool device_hangs_ = false;
  const render::TestHooks hooks_;
  /// The thread that renders. It is the last field because it must end first.
  RenderThread::Handle renderer_;
};

}  // namespace aerostat::viewer
