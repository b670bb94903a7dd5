#pragma once

#include <QObject>
#include <QString>

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
  bool save();
  bool save_as();
  void add_recent_menu(QMenu* menu);

 private:
  void remember(const QString& path);
  void fill_recent();

  Document& document_;
  QWidget* window_;
  QMenu* recent_ = nullptr;
};

}  // namespace aerostat::viewer
