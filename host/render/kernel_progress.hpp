#pragma once

#include <functional>
#include <mutex>
#include <utility>

namespace aerostat::render {

/// Building kernels for longer than this, in seconds, means that they are compiled. A driver loads
/// the kernels that it compiled in a former run in less time. Chosen by measurements with PoCL.
inline constexpr double kLeastCompileSeconds = 2.0;

/// Tracks how much of the kernels is built. A driver tells when a step is done, but not how far it
/// is. Within a step the share is therefore guessed from the time, so that it always grows and
/// reaches the end of the step only when the step is done. One builder and any number of readers
/// may use it at the same time.
class KernelProgress {
 public:
  /// A clock in seconds that never goes back.
  using Seconds = std::function<double()>;

  explicit KernelProgress(Seconds clock = steady_seconds) : clock_(std::move(clock)) {}

  /// Ends the step before and begins one that makes up `share` of the whole.
  void begin(double share);
  /// Ends the last step.
  void finish();

  /// Returns the progress from 0 before the first step to 1 after the last.
  double fraction() const;

 private:
  static double steady_seconds();

  mutable std::mutex mutex_;
  Seconds clock_;
  /// The share of the steps that are done.
  double done_ = 0.0;
  /// The share of the present step.
  double share_ = 0.0;
  double began_s_ = 0.0;
};

}  // namespace aerostat::render
