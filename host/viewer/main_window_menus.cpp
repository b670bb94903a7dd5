#include <QAbstractSpinBox>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QMessageBox>

#include "scene/scene.hpp"
#include "viewer/main_window.hpp"
#include "viewer/picture_view.hpp"
#include "viewer/scene_files.hpp"
#include "viewer/scene_presets.hpp"
#include "viewer/shortcuts_dialog.hpp"
#include "viewer/timeline_panel.hpp"

namespace aerostat::viewer {

QAction* MainWindow::add_action(QMenu* menu, const QString& text, const QKeySequence& keys,
                                const std::function<void()>& act) {
  QAction* action = menu->addAction(text);
  action->setShortcut(keys);
  connect(action, &QAction::triggered, this, [this, act] {
    take_typed();
    act();
  });
  return action;
}

/// Reads a number that is still being typed. A shortcut does not move the focus, so the number
/// would otherwise not count.
void MainWindow::take_typed() {
  if (auto* box = qobject_cast<QAbstractSpinBox*>(focusWidget())) box->interpretText();
}

void MainWindow::add_file_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  QMenu* fresh = menu->addMenu(tr("&New"));
  const QString names[] = {tr("&Snowy Mountains"), tr("&Tropical Island"), tr("&Dunes"),
                           tr("&Meadow")};
  for (int i = 0; i < 4; ++i) {
    add_action(fresh, names[i], i == 0 ? QKeySequence(QKeySequence::New) : QKeySequence(),
               [this, i] { files_->start(static_cast<scene::BiomeKind>(i)); });
  }
  add_action(menu, tr("&Open…"), QKeySequence::Open, [this] { files_->ask_and_open(); });
  files_->add_recent_menu(menu);
  menu->addSeparator();
  add_action(menu, tr("&Save"), QKeySequence::Save, [this] { files_->save(); });
  add_action(menu, tr("Save &As…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
             [this] { files_->save_as(); });
  menu->addSeparator();
  add_action(menu, tr("&Export Picture…"), QKeySequence(Qt::CTRL | Qt::Key_E),
             [this] { export_picture(); });
  add_action(menu, tr("Export Fil&m…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E),
             [this] { export_film(); });
  add_action(menu, tr("Copy &Image"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C),
             [this] { copy_picture(); });
  add_action(menu, tr("Copy as Command &Line"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_L),
             [this] { copy_command(); });
  menu->addSeparator();
  add_action(menu, tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { close(); });
}

void MainWindow::add_edit_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = document_.undo_stack().createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = document_.undo_stack().createRedoAction(this, tr("&Redo"));
  redo->setShortcuts(
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  menu->addActions({undo, redo});
  menu->addSeparator();
  add_action(menu, tr("Put a &Model…"), QKeySequence(Qt::CTRL | Qt::Key_M),
             [this] { ask_for_model(); });
  add_action(menu, tr("&Remove the Model"), QKeySequence(), [this] { models_.remove(); });
  menu->addSeparator();
  add_action(menu, tr("Reset &Everything but the Biome"), QKeySequence(), [this] {
    const std::string kind = document_.source().value("/biome/kind");
    document_.end_gesture();
    document_.replace(tr("Reset Everything"), scene::SceneSource().with({{"/biome/kind", kind}}));
  });
}

void MainWindow::add_view_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  QAction* fit = add_action(menu, tr("&Fit the Window"), QKeySequence(Qt::CTRL | Qt::Key_0),
                            [this] { view_->set_fit(true); });
  QAction* exact =
      add_action(menu, tr("Pixel for Pixel (&1:1)"), QKeySequence(Qt::CTRL | Qt::Key_1),
                 [this] { view_->set_fit(false); });
  auto* group = new QActionGroup(this);
  for (QAction* action : {fit, exact}) {
    action->setCheckable(true);
    group->addAction(action);
  }
  fit->setChecked(true);
  connect(view_, &PictureView::fit_changed, this,
          [fit, exact](bool is_fit) { (is_fit ? fit : exact)->setChecked(true); });
  menu->addSeparator();
  QAction* dock = findChild<QDockWidget*>(QStringLiteral("controls"))->toggleViewAction();
  dock->setShortcut(QKeySequence(Qt::Key_F9));
  menu->addAction(dock);
  QAction* timeline = findChild<QDockWidget*>(QStringLiteral("timeline"))->toggleViewAction();
  timeline->setShortcut(QKeySequence(Qt::Key_F8));
  menu->addAction(timeline);
  add_action(menu, tr("P&lay the Film"), QKeySequence(Qt::CTRL | Qt::Key_Space), [this] {
    findChild<QDockWidget*>(QStringLiteral("timeline"))->show();
    timeline_->is_playing() ? timeline_->pause() : timeline_->play();
  });
  add_action(menu, tr("F&ull Screen"), QKeySequence(Qt::Key_F11),
             [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  add_action(menu, tr("Go to the &Picture"), QKeySequence(Qt::Key_F6),
             [this] { view_->setFocus(Qt::ShortcutFocusReason); });
}

void MainWindow::add_camera_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&Camera"));
  const std::pair<QString, ViewKind> kinds[] = {{tr("From &Outside"), ViewKind::outside},
                                                {tr("From the &Basket"), ViewKind::basket},
                                                {tr("&Free"), ViewKind::free}};
  int key = Qt::Key_2;
  for (const auto& [text, kind] : kinds) {
    add_action(menu, text, QKeySequence(static_cast<int>(Qt::CTRL) | key++),
               [this, chosen = kind] { camera_.set_kind(chosen); });
  }
  menu->addSeparator();
  add_action(menu, tr("As in the file"), QKeySequence(),
             [this] { camera_.take_camera_of(tr("As in the file"), document_.saved()); });
  QAction* end_of_scenes = menu->addSeparator();
  connect(menu, &QMenu::aboutToShow, this,
          [this, menu, end_of_scenes] { list_scene_cameras(menu, end_of_scenes); });
  const QStringList presets = CameraControl::preset_names();
  for (int i = 0; i < presets.size(); ++i) {
    add_action(menu, presets[i], QKeySequence(static_cast<int>(Qt::ALT) | (Qt::Key_1 + i)),
               [this, i] { camera_.apply_preset(i); });
  }
  menu->addSeparator();
  add_action(menu, tr("&Put the Balloon by a Click"), QKeySequence(Qt::CTRL | Qt::Key_B), [this] {
    view_->set_placing(true);
    view_->setFocus();
  });
}

/// Lists the cameras of the installed scenes that have the document's biome.
void MainWindow::list_scene_cameras(QMenu* menu, QAction* end) {
  qDeleteAll(scene_cameras_);
  scene_cameras_.clear();
  for (const ScenePreset& preset : scene_presets(document_.scene().biome.kind)) {
    auto* action = new QAction(preset.name, menu);
    connect(action, &QAction::triggered, this,
            [this, preset] { camera_.take_camera_of(preset.name, preset.scene); });
    menu->insertAction(end, action);
    scene_cameras_.push_back(action);
  }
}

void MainWindow::add_help_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  add_action(menu, tr("&Mouse and Keys"), QKeySequence(Qt::Key_F1),
             [this] { ShortcutsDialog(*this).exec(); });
  add_action(menu, tr("&About Aerostat"), QKeySequence(), [this] {
    QMessageBox::about(
        this, tr("About Aerostat"),
        tr("<h3>Aerostat %1</h3><p>Pictures of a hot-air balloon before a mountain "
           "landscape, ray-traced on OpenCL.</p><p>MIT licence. Uses Qt %2 under "
           "the LGPL, version 3.</p>")
            .arg(QApplication::applicationVersion(), QString::fromLatin1(qVersion())));
  });
}

}  // namespace aerostat::viewer
