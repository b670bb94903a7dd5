#pragma once

#include <atomic>
#include <stop_token>
#include <thread>

namespace aerostat::cli {

/// Makes the first SIGINT or SIGTERM ask for a stop instead of ending the process, while the
/// object lives. If the process does not end by itself within half a second, or within the grace
/// that is set, it is ended with the signal's exit code. That happens because building a large
/// world is not watched for stops. A second signal has the system's effect at once. Signals that
/// were ignored when the object was made stay ignored. Only one object may exist at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return source_.get_token(); }

  /// Sets the time that the process has to end by itself, in milliseconds. kNoLimit is for the time
  /// in which something is saved. It may be called from any thread and after the signal.
  void set_grace(int milliseconds) { grace_ms_ = milliseconds; }
  static constexpr int kNoLimit = -1;

 private:
  void watch(int pipe);

  std::stop_source source_;
  std::atomic<int> grace_ms_ = 500;
  std::thread watcher_;
};

/// Returns the shell's exit code for the signal that asked for a stop: 130 for SIGINT, 143 for
/// SIGTERM. Returns 130 if there was no signal.
int interrupt_exit_code();

}  // namespace aerostat::cli
