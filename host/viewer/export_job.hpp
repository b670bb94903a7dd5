#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/file.hpp"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::viewer {

/// Renders a whole scene and writes it, on a thread of its own. The job ends when the picture is
/// written, or soon after it is cancelled or destroyed. A job that is cancelled or destroyed writes
/// nothing.
class ExportJob : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  ~ExportJob() override;

  /// Starts the job. Call it once and after its signals are connected, because it may fail at once.
  /// `scene` is not resolved. The suffix of the file selects PNG or EXR.
  void start(const scene::Scene& scene, const QString& path, const QString& device);
  void cancel();
  /// Returns the bytes of the picture's file after `obstructed` was sent.
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 Q_SIGNALS:
  /// Reports the progress. `fraction` is the share of the whole work from 0 to 1, and `stage` is a
  /// word for the present part of it.
  void progressed(double fraction, const QString& stage);
  /// Reports the end of the job. `error` is empty if the file was written or the job was cancelled.
  void finished(bool written, const QString& error);
  /// Reports, instead of `finished`, that the picture is made but another program wrote its file in
  /// the meantime. The file is left unchanged.
  void obstructed();

 private:
  void run(const std::stop_token& stop, const scene::Scene& scene, const QString& path,
           const QString& device);

  /// The stamp of the picture's file before the render.
  FileStamp before_;
  std::vector<std::uint8_t> bytes_;
  std::jthread thread_;
};

}  // namespace aerostat::viewer
