#pragma once

#include <stop_token>

namespace aerostat {

/// Lets a token stop the long work of its thread while the object lives. The work asks
/// `current_stop` once and `stop_if_asked` from time to time. Work that starts other threads
/// hands them the token itself.
class StopScope {
 public:
  explicit StopScope(std::stop_token stop);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

 private:
  std::stop_token former_;
};

/// Returns the token of the innermost scope of this thread. Without any scope, it is a token that
/// never stops.
std::stop_token current_stop();

/// Throws Error{interrupted} if a stop was requested.
void stop_if_asked(const std::stop_token& stop);

}  // namespace aerostat
