#pragma once

#include <stop_token>
#include <thread>

namespace aerostat::cli {

/// While it lives, the first SIGINT or SIGTERM asks for a stop instead of ending the process. If
/// the process does not end by itself within a second (building a large world is not watched for
/// stops), it is ended with the signal's exit code. A second signal has the system's effect at
/// once. Signals that were ignored when it began stay ignored. One at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return source_.get_token(); }

 private:
  void watch(int pipe);

  std::stop_source source_;
  std::thread watcher_;
};

/// 130 or 143: the shell's exit code for the signal that asked for a stop; 130 if there was none.
int interrupt_exit_code();

}  // namespace aerostat::cli
