#pragma once

#include <stop_token>

namespace aerostat {

/// While it lives, long work on its thread may be given up by this token. Work asks `current_stop`
/// once and `stop_if_asked` from time to time; it hands the token to what it begins on other
/// threads itself.
class StopScope {
 public:
  explicit StopScope(std::stop_token stop);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

 private:
  std::stop_token former_;
};

/// The token of the innermost scope of this thread; one that never stops without any.
std::stop_token current_stop();

/// Throws Error{interrupted} if a stop was requested.
void stop_if_asked(const std::stop_token& stop);

}  // namespace aerostat
