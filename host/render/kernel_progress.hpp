#pragma once

#include <functional>
#include <mutex>
#include <utility>

namespace aerostat::render {

/// How far the building of the kernels has come. A driver tells when a step is done, never how far
/// it is: within a step the share is guessed from the time it takes, so that it always grows and
/// reaches the step's end only when the step does. For one builder and any number of readers.
class KernelProgress {
 public:
  using Seconds = std::function<double()>;  // a clock that never goes back

  explicit KernelProgress(Seconds clock = steady_seconds) : clock_(std::move(clock)) {}

  /// A step that makes up `share` of the whole begins, and the one before it is done.
  void begin(double share);
  /// The last step is done.
  void finish();

  /// From 0 to 1: 0 before the first step, 1 after the last.
  double fraction() const;

 private:
  static double steady_seconds();

  mutable std::mutex mutex_;
  Seconds clock_;
  double done_ = 0.0;   // share of the steps that are done
  double share_ = 0.0;  // of the step under way
  double began_s_ = 0.0;
};

}  // namespace aerostat::render
