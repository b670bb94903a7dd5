#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <stop_token>

#include "scene/source.hpp"
#include "viewer/output_job.hpp"

namespace aerostat::film {
struct FilmProgress;
}

namespace aerostat::viewer {

/// Makes a film as the command `aerostat film` does. Frames that are made stay when the job is
/// cancelled, and the next job goes on from them.
class FilmJob : public OutputJob {
  Q_OBJECT

 public:
  using Handle = std::unique_ptr<FilmJob, Ender>;
  static Handle make() { return Handle(new FilmJob); }

  /// Starts the job. Call it once and after its signals are connected, because it may fail at once.
  /// The suffix of the file selects the kind of film.
  void start(const scene::SceneSource& source, const QString& path, const QString& device);

 private:
  void run(const std::stop_token& stop, const scene::SceneSource& source, const QString& path,
           const QString& device);
  void tell(const film::FilmProgress& now);

  /// Exists while signs of the device are expected. Building the world, writing frames and encoding
  /// give none.
  std::optional<DeviceWatch::Busy> busy_;
};

}  // namespace aerostat::viewer
