#include "viewer/document.hpp"

#include <QUndoCommand>
#include <chrono>
#include <filesystem>
#include <new>

#include "core/error.hpp"
#include "elevation/open.hpp"
#include "staging/scene_text.hpp"
#include "staging/stage.hpp"

namespace aerostat::viewer {
namespace {

constexpr std::chrono::milliseconds kSameStep(1000);

/// Returns what follows from files that a saved scene names elsewhere.
QString tell_of(const std::vector<std::string>& outside) {
  const QString first = QString::fromStdString(outside.front());
  const auto further = static_cast<int>(outside.size()) - 1;
  const QString files =
      further == 0 ? first : Document::tr("%1 and %n more", nullptr, further).arg(first);
  return Document::tr(
             "Saved. The scene names files outside of its folder: %1. This window opens it, but "
             "aerostat render needs --allow-external-paths. Without that, copy them beside the "
             "scene and name the copies.")
      .arg(files);
}

}  // namespace

/// A step that can be undone and that goes from one source to another. The steps of one gesture
/// with the same key become one step.
class SourceCommand : public QUndoCommand {
 public:
  SourceCommand(Document& document, scene::SceneSource after, const QString& what, QString key)
      : QUndoCommand(what),
        document_(document),
        before_(document.source_),
        after_(std::move(after)),
        key_(std::move(key)),
        gesture_(document.gesture_),
        made_(std::chrono::steady_clock::now()) {}

  void undo() override { document_.show(before_); }
  void redo() override { document_.show(after_); }
  int id() const override { return 1; }

  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const SourceCommand*>(other);
    if (next->key_ != key_ || key_.isEmpty() || next->gesture_ != gesture_) return false;
    if (next->made_ - made_ > kSameStep) return false;
    after_ = next->after_;
    made_ = next->made_;
    return true;
  }

 private:
  Document& document_;
  scene::SceneSource before_, after_;
  QString key_;
  int gesture_;
  std::chrono::steady_clock::time_point made_;
};

Document::Document(QObject* parent)
    : QObject(parent), reliefs_(std::make_shared<world::ReliefCache>()) {
  undo_.setUndoLimit(kMostSteps);
}

template <typename Action>
bool Document::guarded(Action action) {
  try {
    action();
    return true;
  } catch (const std::bad_alloc&) {
    Q_EMIT failed(tr("Out of memory"));
  } catch (const scene::BadScene& bad) {
    const QString first = QString::fromStdString(bad.lines().front());
    const auto further = static_cast<int>(bad.faults().size()) - 1;
    Q_EMIT failed(further == 0 ? first : tr("%1 Further faults: %2").arg(first).arg(further));
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
  }
  // The signal lets every widget that shows the refused value return to the value of the document.
  Q_EMIT changed();
  return false;
}

QString Document::value(const QString& pointer) const {
  return QString::fromStdString(source_.value(pointer.toStdString()));
}

/// Returns the pointers of the places on the Earth that positions in `changes` replace. A place
/// would win over a position when the file is read again.
std::vector<std::string> Document::replaced_places(
    const std::vector<scene::Override>& changes) const {
  std::vector<std::string> places;
  for (const scene::Override& one : changes) {
    const std::size_t at = one.pointer.find("/position");
    if (at == std::string::npos) continue;
    const std::string place = one.pointer.substr(0, at) + "/at";
    if (source_.gives(place)) places.push_back(place);
  }
  return places;
}

bool Document::change(const QString& what, const std::vector<scene::Override>& changes) {
  return guarded([&] {
    QString key = what;
    for (const auto& one : changes) key += QString::fromStdString("\n" + one.pointer);
    replace(what, source_.without(replaced_places(changes)).with(changes), key);
  });
}

bool Document::set(const QString& what, const QString& pointer, const QString& json) {
  return change(what, {{pointer.toStdString(), json.toStdString()}});
}

bool Document::reset(const QString& what, const QStringList& pointers) {
  return guarded([&] {
    std::vector<std::string> names;
    for (const QString& pointer : pointers) names.push_back(pointer.toStdString());
    replace(what, source_.without(names));
  });
}

void Document::replace(const QString& what, const scene::SceneSource& source, const QString& key) {
  if (source.text() == source_.text()) {
    Q_EMIT changed();
    return;
  }
  undo_.push(new SourceCommand(*this, source, what, key));
}

void Document::show(const scene::SceneSource& source) {
  source_ = source;
  Q_EMIT changed();
}

/// Returns the scene with what it leaves open on real land chosen. The files stay in memory for the
/// next call.
scene::SceneSource Document::staged(const scene::SceneSource& source) {
  return staging::stage(source, *reliefs_).source;
}

void Document::start(const scene::SceneSource& source, const QString& path) {
  begin(source, path, path.isEmpty() ? FileStamp() : file_stamp(path.toStdString()));
}

void Document::begin(const scene::SceneSource& source, const QString& path,
                     const FileStamp& stamp) {
  undo_.clear();
  saved_ = source;
  path_ = path;
  stamp_ = stamp;
  show(source);
  Q_EMIT file_changed();
}

bool Document::open(const QString& path) {
  return guarded([&] {
    // The stamp is taken before the file is read, so it belongs to what is read or to an older
    // state.
    const std::string file = path.toStdString();
    const FileStamp stamp = file_stamp(file);
    if (!path.endsWith(QLatin1String(".json")) && elevation::is_elevation(file)) {
      // The scene around a file of heights has no file of its own yet.
      begin(staged(staging::scene_around(file)), {}, {});
    } else {
      staging::require_scene_text(file);
      begin(staged(scene::SceneSource::from_file(file)), path, stamp);
    }
  });
}

bool Document::save(const QString& path) {
  return guarded([&] {
    const std::filesystem::path folder = std::filesystem::path(path.toStdString()).parent_path();
    const std::string text = source_.text_in(folder);
    write_file(path.toStdString(),
               {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    path_ = path;
    stamp_ = file_stamp(path.toStdString());
    saved_ = source_;
    undo_.setClean();
    end_gesture();
    Q_EMIT file_changed();
    const auto outside = source_.files_outside(folder);
    if (!outside.empty()) Q_EMIT saved_with(tell_of(outside));
  });
}

}  // namespace aerostat::viewer
