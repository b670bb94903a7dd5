#pragma once

#include <QObject>
#include <QString>
#include <stop_token>
#include <thread>

#include "scene/source.hpp"

namespace aerostat::viewer {

/// Makes a film as the command `aerostat film` does, on a thread of its own. Frames that are made
/// stay when the job is cancelled, and the next job goes on from them.
class FilmJob : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  ~FilmJob() override;

  /// Starts the job. Call it once and after its signals are connected, because it may fail at once.
  /// The suffix of the file selects the kind of film.
  void start(const scene::SceneSource& source, const QString& path, const QString& device);
  void cancel();

 Q_SIGNALS:
  /// Reports the progress. `fraction` is the share of the frames from 0 to 1, and `text` says what
  /// is done.
  void progressed(double fraction, const QString& text);
  /// Reports the end. `message` says what was made or what went wrong; it is empty if the job was
  /// cancelled.
  void finished(bool written, const QString& message);

 private:
  void run(const std::stop_token& stop, const scene::SceneSource& source, const QString& path,
           const QString& device);

  std::jthread thread_;
};

}  // namespace aerostat::viewer
