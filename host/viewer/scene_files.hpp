#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

#include "viewer/document.hpp"

class QMenu;
class QWidget;

namespace aerostat::viewer {

/// Scene files as the user deals with them: dialogs, recent ones, and the question what becomes of
/// changes that are not saved.
class SceneFiles : public QObject {
  Q_OBJECT

 public:
  SceneFiles(Document& document, QWidget* window);

  /// Whether the document may be left; asks if it was changed.
  bool may_discard();
  void start(scene::BiomeKind biome);
  bool open(const QString& path);
  void ask_and_open();
  /// Asks if another program wrote the file meanwhile.
  bool save();
  bool save_as();
  /// Opens the document's file again; its own changes are lost.
  void reload();
  void add_recent_menu(QMenu* menu);

 Q_SIGNALS:
  /// Another program wrote the document's file or removed it.
  void changed_elsewhere(const QString& message, bool can_reload);

 private:
  void watch();
  void look_at_file();
  bool may_replace(const QString& path);
  void remember(const QString& path);
  void fill_recent();

  Document& document_;
  QWidget* window_;
  QMenu* recent_ = nullptr;
  QFileSystemWatcher watcher_;
  QTimer settled_;   // a file is written in several steps
  FileStamp known_;  // that the user was told of
};

}  // namespace aerostat::viewer
