#pragma once

#include <QByteArray>
#include <QString>
#include <memory>
#include <stop_token>

#include "core/file.hpp"
#include "viewer/output_job.hpp"

namespace aerostat::render {
struct Progress;
}

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::viewer {

/// Renders a whole scene and writes it. A job that is cancelled or reset writes nothing.
class ExportJob : public OutputJob {
  Q_OBJECT

 public:
  using Handle = std::unique_ptr<ExportJob, Ender>;
  static Handle make() { return Handle(new ExportJob); }

  /// Starts the job. Call it once and after its signals are connected, because it may fail at once.
  /// `scene` is not resolved. The suffix of the file selects PNG or EXR.
  void start(const scene::Scene& scene, const QString& path, const QString& device);

 Q_SIGNALS:
  /// Reports, instead of `finished`, that the picture is made but another program wrote its file in
  /// the meantime. The file is left unchanged. `bytes` are those of the picture's file.
  void obstructed(const QByteArray& bytes);

 private:
  void tell(const render::Progress& progress);
  void run(const std::stop_token& stop, const scene::Scene& scene, const QString& path,
           const QString& device);

  /// The stamp of the picture's file before the render.
  FileStamp before_;
};

}  // namespace aerostat::viewer
