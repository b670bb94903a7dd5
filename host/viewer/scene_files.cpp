#include "viewer/scene_files.hpp"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

namespace aerostat::viewer {
namespace {

constexpr int kMostRecent = 9;
const QString kRecentKey = QStringLiteral("recent");

QString filter() {
  return SceneFiles::tr("Scenes (*.json)") + ";;" + SceneFiles::tr("Elevation data") +
         " (*.tif *.tiff *.hgt *.zip *.asc *.dem *.dt0 *.dt1 *.dt2 *.nc *.img *.png *.exr *.r16 "
         "*.r32 "
         "*.raw *.bil);;" +
         SceneFiles::tr("All files (*)");
}

}  // namespace

SceneFiles::SceneFiles(Document& document, QWidget* window)
    : QObject(window), document_(document), window_(window) {
  settled_.setSingleShot(true);
  settled_.setInterval(200);
  const auto wait = [this] { settled_.start(); };
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, wait);
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, wait);
  connect(&settled_, &QTimer::timeout, this, &SceneFiles::look_at_file);
  connect(&document, &Document::file_changed, this, &SceneFiles::watch);
}

/// Watches the file and its folder. The folder is needed because a replaced file is a new one for
/// the watcher.
void SceneFiles::watch() {
  known_ = document_.stamp();
  const QStringList watched = watcher_.files() + watcher_.directories();
  if (!watched.isEmpty()) watcher_.removePaths(watched);
  if (document_.path().isEmpty()) return;
  watcher_.addPath(QFileInfo(document_.path()).absolutePath());
  watcher_.addPath(document_.path());
}

void SceneFiles::look_at_file() {
  if (document_.path().isEmpty()) return;
  const FileStamp now = file_stamp(document_.path().toStdString());
  if (now == known_) return;
  known_ = now;
  // The file has returned to the state that the document knows.
  if (now == document_.stamp()) return;
  const QString name = QFileInfo(document_.path()).fileName();
  if (now.exists()) {
    watcher_.addPath(document_.path());
    Q_EMIT changed_elsewhere(tr("Another program changed %1.").arg(name), true);
  } else {
    Q_EMIT changed_elsewhere(
        tr("Another program removed or renamed %1. Saving creates it again.").arg(name), false);
  }
}

void SceneFiles::reload() {
  document_.open(document_.path());
}

bool SceneFiles::may_discard() {
  if (!document_.is_modified()) return true;
  const auto answer = QMessageBox::question(
      window_, tr("Unsaved Changes"), tr("The scene was changed. Save it first?"),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

void SceneFiles::start(scene::BiomeKind biome) {
  if (!may_discard()) return;
  constexpr const char* kNames[] = {"snow", "tropical", "sand", "meadow"};
  document_.start(
      scene::SceneSource().with({{"/biome/kind", kNames[static_cast<std::size_t>(biome)]}}), {});
}

bool SceneFiles::open(const QString& path) {
  if (!may_discard()) return false;
  const QString whole = QFileInfo(path).absoluteFilePath();
  if (!document_.open(whole)) return false;
  remember(whole);
  return true;
}

void SceneFiles::ask_and_open() {
  const QString folder = QFileInfo(document_.path()).absolutePath();
  const QString path = QFileDialog::getOpenFileName(window_, tr("Open a Scene"), folder, filter());
  if (!path.isEmpty()) open(path);
}

bool SceneFiles::save() {
  if (document_.path().isEmpty()) return save_as();
  const FileStamp now = file_stamp(document_.path().toStdString());
  if (!now.exists() || now == document_.stamp()) return document_.save(document_.path());
  QMessageBox box(QMessageBox::Warning, tr("File Changed"),
                  tr("Another program changed %1 since it was opened or saved here.")
                      .arg(QFileInfo(document_.path()).fileName()),
                  QMessageBox::Cancel, window_);
  box.setInformativeText(
      tr("Overwriting it loses what that program wrote; reloading it loses the "
         "changes made here."));
  auto* overwrite = box.addButton(tr("Overwrite"), QMessageBox::DestructiveRole);
  auto* another = box.addButton(tr("Save As…"), QMessageBox::AcceptRole);
  auto* again = box.addButton(tr("Reload"), QMessageBox::ResetRole);
  box.setDefaultButton(QMessageBox::Cancel);
  box.exec();
  if (box.clickedButton() == overwrite) return document_.save(document_.path());
  if (box.clickedButton() == another) return save_as();
  if (box.clickedButton() == again) reload();
  return false;
}

/// Asks whether a file may be replaced if the file dialog did not ask.
bool SceneFiles::may_replace(const QString& path) {
  if (!QFileInfo::exists(path)) return true;
  return QMessageBox::question(
             window_, tr("Save the Scene"),
             tr("%1 already exists. Replace it?").arg(QFileInfo(path).fileName())) ==
         QMessageBox::Yes;
}

bool SceneFiles::save_as() {
  QString path =
      QFileDialog::getSaveFileName(window_, tr("Save the Scene"), document_.path(), filter());
  if (path.isEmpty()) return false;
  if (QFileInfo(path).suffix().isEmpty()) {
    path += QStringLiteral(".json");
    if (!may_replace(path)) return false;
  }
  if (!document_.save(path)) return false;
  remember(path);
  return true;
}

void SceneFiles::add_recent_menu(QMenu* menu) {
  recent_ = menu->addMenu(tr("Open &Recent"));
  fill_recent();
}

void SceneFiles::remember(const QString& path) {
  QSettings settings;
  QStringList paths = settings.value(kRecentKey).toStringList();
  paths.removeAll(path);
  paths.prepend(path);
  settings.setValue(kRecentKey, paths.mid(0, kMostRecent));
  fill_recent();
}

void SceneFiles::fill_recent() {
  if (recent_ == nullptr) return;
  recent_->clear();
  int number = 0;
  for (const QString& path : QSettings().value(kRecentKey).toStringList()) {
    QString shown = QFileInfo(path).fileName();
    shown.replace(QLatin1String("&"), QLatin1String("&&"));
    QAction* action = recent_->addAction(QStringLiteral("&%1  %2").arg(++number).arg(shown));
    action->setToolTip(path);
    action->setStatusTip(path);
    connect(action, &QAction::triggered, this, [this, path] { open(path); });
  }
  recent_->setEnabled(number > 0);
}

}  // namespace aerostat::viewer
