#include "viewer/scene_files.hpp"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>

namespace aerostat::viewer {
namespace {

constexpr int kMostRecent = 9;
const QString kRecentKey = QStringLiteral("recent");

QString filter() {
  return SceneFiles::tr("Scenes (*.json)") + ";;" + SceneFiles::tr("All files (*)");
}

}  // namespace

SceneFiles::SceneFiles(Document& document, QWidget* window)
    : QObject(window), document_(document), window_(window) {}

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
  constexpr const char* kNames[] = {"snow", "tropical", "sand"};
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
  return document_.path().isEmpty() ? save_as() : document_.save(document_.path());
}

bool SceneFiles::save_as() {
  QString path =
      QFileDialog::getSaveFileName(window_, tr("Save the Scene"), document_.path(), filter());
  if (path.isEmpty()) return false;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".json");
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
