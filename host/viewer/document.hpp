#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <memory>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "scene/source.hpp"
#include "world/surface.hpp"

namespace aerostat::viewer {

/// The steps that can be undone. Each keeps the scene before and after it, some 90 KiB.
inline constexpr int kMostSteps = 300;

/// The scene that is being edited, with its file and the history of its changes. Errors are
/// reported by `failed` and change nothing.
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);

  const scene::SceneSource& source() const { return source_; }
  const scene::Scene& scene() const { return source_.scene(); }
  QUndoStack& undo_stack() { return undo_; }
  /// Returns the path of the file, or an empty string for a scene that has no file yet.
  const QString& path() const { return path_; }
  bool is_modified() const { return !undo_.isClean(); }
  /// Returns the scene as it is in the file. If there is no file, it is the scene that the document
  /// started with.
  const scene::SceneSource& saved() const { return saved_; }

  /// Returns the JSON text of the value that is in effect at a pointer.
  QString value(const QString& pointer) const;

  /// Makes changes as one step that can be undone under the name `what`. Steps with the same `what`
  /// and the same pointers in quick succession become one step. Returns false if the result is not
  /// a scene.
  bool change(const QString& what, const std::vector<scene::Override>& changes);
  bool set(const QString& what, const QString& pointer, const QString& json);
  /// Resets values to their defaults.
  bool reset(const QString& what, const QStringList& pointers);
  /// Replaces the source as one step that can be undone. It serves to make several changes at once.
  void replace(const QString& what, const scene::SceneSource& source, const QString& key = {});
  /// Ends the current gesture, so that the next change is a step of its own.
  void end_gesture() { ++gesture_; }

  /// Starts again with another scene. `path` may be empty.
  void start(const scene::SceneSource& source, const QString& path);
  /// Opens a scene file, or makes a scene around a file of elevation data, which then has no path.
  bool open(const QString& path);
  bool save(const QString& path);
  /// Returns the stamp of the file at the time when it was opened or saved. If the file has another
  /// stamp now, another program wrote it.
  const FileStamp& stamp() const { return stamp_; }

 Q_SIGNALS:
  void changed();
  /// Reports that the document has another file, or that its file was saved.
  void file_changed();
  void failed(const QString& message);
  /// Reports what the user should know about a file that was saved.
  void saved_with(const QString& message);

 private:
  friend class SourceCommand;
  template <typename Action>
  bool guarded(Action action);
  std::vector<std::string> replaced_places(const std::vector<scene::Override>& changes) const;
  void show(const scene::SceneSource& source);
  scene::SceneSource staged(const scene::SceneSource& source);
  void begin(const scene::SceneSource& source, const QString& path, const FileStamp& stamp);

  scene::SceneSource source_, saved_;
  std::shared_ptr<world::ReliefCache> reliefs_;
  QString path_;
  FileStamp stamp_;
  QUndoStack undo_;
  int gesture_ = 0;
};

}  // namespace aerostat::viewer
