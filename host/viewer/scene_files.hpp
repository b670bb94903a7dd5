#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

#include "viewer/document.hpp"

class QMenu;
class QWidget;

namespace aerostat::viewer {

/// Handles scene files for the user. It shows dialogs, lists recent files, and asks what to do with
/// changes that are not saved.
class SceneFiles : public QObject {
  Q_OBJECT

 public:
  SceneFiles(Document& document, QWidget* window);

  /// Returns whether the document may be left. Asks the user if the document was changed.
  bool may_discard();
  void start(scene::BiomeKind biome);
  bool open(const QString& path);
  void ask_and_open();
  /// Saves the document. Asks first if another program wrote the file in the meantime.
  bool save();
  bool save_as();
  /// Opens the document's file again. Changes that are not saved are lost.
  void reload();
  void add_recent_menu(QMenu* menu);

 Q_SIGNALS:
  /// Reports that another program wrote the document's file or removed it.
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
  /// Waits until a file is complete, because files are written in several steps.
  QTimer settled_;
  /// The stamp of the file that the user was last told about.
  FileStamp known_;
};

}  // namespace aerostat::viewer
