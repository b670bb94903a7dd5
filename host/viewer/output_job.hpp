#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <future>
#include <memory>
#include <stop_token>
#include <thread>

#include "viewer/device_watch.hpp"

namespace aerostat::viewer {

/// Makes a file on a thread of its own, with a device that may hang. The job ends when the file is
/// written, or soon after it is cancelled or its handle is reset.
class OutputJob : public QObject {
  Q_OBJECT

 public:
  /// Cancels a job and waits for its end. If the device hangs, the job is left behind.
  struct Ender {
    void operator()(OutputJob* job) const;
  };
  using Handle = std::unique_ptr<OutputJob, Ender>;

  void cancel();
  /// Returns whether the device does not answer.
  bool is_silent() const { return watch_.is_silent(); }

 Q_SIGNALS:
  /// Reports the progress. `fraction` is the share of the whole work from 0 to 1, and `text` says
  /// what is done at present.
  void progressed(double fraction, const QString& text);
  /// Reports the end of the job. `message` says what was made or what went wrong; it is empty if
  /// the job was cancelled.
  void finished(bool written, const QString& message);
  /// Reports that the device has not answered for some time. `finished` follows if it answers after
  /// all.
  void fell_silent(int seconds);

 protected:
  OutputJob();
  ~OutputJob() override = default;
  /// Does the work on the thread of the job, which begins now. Its errors are reported by
  /// `finished`.
  void begin(std::function<void(const std::stop_token& stop)> work);
  DeviceWatch& watch() { return watch_; }

 private:
  void run(const std::function<void(const std::stop_token& stop)>& work,
           const std::stop_token& stop);

  DeviceWatch watch_;
  std::promise<void> end_;
  std::future<void> ended_ = end_.get_future();
  std::jthread thread_;
};

}  // namespace aerostat::viewer
