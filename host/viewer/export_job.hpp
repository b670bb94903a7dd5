#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <stop_token>
#include <thread>

#include "core/file.hpp"
#include "scene/scene.hpp"

namespace aerostat::viewer {

/// Renders a scene in full and writes it, on a thread of its own. Ends when it is done, or soon
/// after it is cancelled or destroyed; then nothing is written.
class ExportJob : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  ~ExportJob() override;

  /// Once, when its signals are connected: it may fail at once. `scene` is not resolved; the file's
  /// suffix says PNG or EXR.
  void start(const scene::Scene& scene, const QString& path, const QString& device);
  void cancel();
  /// Of the picture's file, once `obstructed` was sent.
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 Q_SIGNALS:
  /// Of the whole, 0 to 1; `stage` is a word for it.
  void progressed(double fraction, const QString& stage);
  /// `error` is empty if the file was written, or if the job was cancelled.
  void finished(bool written, const QString& error);
  /// Instead of `finished`: the picture is made, but another program wrote its file meanwhile,
  /// which was left alone.
  void obstructed();

 private:
  void run(const std::stop_token& stop, scene::Scene scene, const QString& path,
           const QString& device);

  FileStamp before_;  // of the picture's file
  std::vector<std::uint8_t> bytes_;
  std::jthread thread_;
};

}  // namespace aerostat::viewer
