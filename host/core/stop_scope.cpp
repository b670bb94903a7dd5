#include "core/stop_scope.hpp"

#include <utility>

#include "core/error.hpp"

namespace aerostat {
namespace {

thread_local std::stop_token innermost;

}  // namespace

StopScope::StopScope(std::stop_token stop) : former_(std::exchange(innermost, std::move(stop))) {}

StopScope::~StopScope() {
  innermost = std::move(former_);
}

std::stop_token current_stop() {
  return innermost;
}

void stop_if_asked(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Error(ErrorKind::interrupted, "interrupted");
}

}  // namespace aerostat
