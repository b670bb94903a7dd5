#pragma once

#include <functional>
#include <string>

namespace aerostat {

/// Receives the library's messages for the user: one complete sentence each, no line end.
using LogSink = std::function<void(const std::string& message)>;

/// Replaces the sink (default: a line on stderr that begins with "aerostat: ") and returns the
/// former one. An empty sink silences the library. Call it before other threads run.
LogSink set_log_sink(LogSink sink);

/// Tells the user something that does not stop the work. Safe from any thread.
void warn(const std::string& message);

}  // namespace aerostat
