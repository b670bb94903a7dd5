#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QUndoStack>

#include "core/file.hpp"
#include "scene/source.hpp"

namespace aerostat::viewer {

/// The scene that is being edited, the file it belongs to, and what was done to it. Errors are
/// reported by `failed` and change nothing.
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);

  const scene::SceneSource& source() const { return source_; }
  const scene::Scene& scene() const { return source_.scene(); }
  QUndoStack& undo_stack() { return undo_; }
  /// Empty for a scene that has no file yet.
  const QString& path() const { return path_; }
  bool is_modified() const { return !undo_.isClean(); }
  /// As the file has it; the first defaults without one.
  const scene::SceneSource& saved() const { return saved_; }

  /// The JSON text of the value that counts at a pointer.
  QString value(const QString& pointer) const;

  /// Makes changes, as one step that can be undone under the name `what`. Steps with the same
  /// `what` and pointers in quick succession become one. False if that is no scene.
  bool change(const QString& what, const std::vector<scene::Override>& changes);
  bool set(const QString& what, const QString& pointer, const QString& json);
  /// Gives values back to their defaults.
  bool reset(const QString& what, const QStringList& pointers);
  /// Several of the above as one: goes on from another source.
  void replace(const QString& what, const scene::SceneSource& source, const QString& key = {});
  /// The next change is a step of its own.
  void end_gesture() { ++gesture_; }

  /// Begins anew. `path` may be empty.
  void start(const scene::SceneSource& source, const QString& path);
  bool open(const QString& path);
  bool save(const QString& path);
  /// Of the file as it was opened or saved; another one now means that another program wrote it.
  const FileStamp& stamp() const { return stamp_; }

 Q_SIGNALS:
  void changed();
  /// Another file, or the same one saved.
  void file_changed();
  void failed(const QString& message);

 private:
  friend class SourceCommand;
  template <typename Action>
  bool guarded(Action action);
  void show(const scene::SceneSource& source);
  void begin(const scene::SceneSource& source, const QString& path, const FileStamp& stamp);

  scene::SceneSource source_, saved_;
  QString path_;
  FileStamp stamp_;
  QUndoStack undo_;
  int gesture_ = 0;
};

}  // namespace aerostat::viewer
