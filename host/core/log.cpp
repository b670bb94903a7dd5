#include "core/log.hpp"

#include <cstdio>
#include <mutex>
#include <utility>

namespace aerostat {
namespace {

std::mutex mutex;

LogSink& current_sink() {
  static LogSink sink = [](const std::string& message) {
    std::fprintf(stderr, "aerostat: %s\n", message.c_str());
  };
  return sink;
}

}  // namespace

LogSink set_log_sink(LogSink sink) {
  const std::lock_guard lock(mutex);
  return std::exchange(current_sink(), std::move(sink));
}

void warn(const std::string& message) {
  const std::lock_guard lock(mutex);
  if (current_sink()) current_sink()(message);
}

}  // namespace aerostat
