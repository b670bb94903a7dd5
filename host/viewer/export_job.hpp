#pragma once

#include <QObject>
#include <QString>
#include <future>
#include <memory>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/file.hpp"
#include "viewer/device_watch.hpp"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::viewer {

/// Renders a whole scene and writes it, on a thread of its own. The job ends when the picture is
/// written, or soon after it is cancelled or its handle is reset. A job that is cancelled or reset
/// writes nothing.
class ExportJob : public QObject {
  Q_OBJECT

 public:
  /// Cancels a job and waits for its end. If the device hangs, the job is left behind.
  struct Ender {
    void operator()(ExportJob* job) const;
  };
  using Handle = std::unique_ptr<ExportJob, Ender>;
  static Handle make() { return Handle(new ExportJob); }

  /// Starts the job. Call it once and after its signals are connected, because it may fail at once.
  /// `scene` is not resolved. The suffix of the file selects PNG or EXR.
  void start(const scene::Scene& scene, const QString& path, const QString& device);
  void cancel();
  /// Returns whether the device does not answer.
  bool is_silent() const { return watch_.is_silent(); }
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
  /// Reports that the device has not answered for some time. `finished` follows if it answers after
  /// all.
  void fell_silent(int seconds);

 private:
  ExportJob();
  ~ExportJob() override = default;
  void tell(const render::Progress& progress);
  void run(const std::stop_token& stop, const scene::Scene& scene, const QString& path,
           const QString& device);

  /// The stamp of the picture's file before the render.
  FileStamp before_;
  std::vector<std::uint8_t> bytes_;
  DeviceWatch watch_;
  std::promise<void> end_;
  std::future<void> ended_ = end_.get_future();
  std::jthread thread_;
};

}  // namespace aerostat::viewer
