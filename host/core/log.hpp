#pragma once

#include <functional>
#include <string>

namespace aerostat {

/// Receives the library's messages for the user. Each message is one complete sentence without a
/// line end.
using LogSink = std::function<void(const std::string& message)>;

/// Replaces the sink and returns the former one. The default sink writes a line to stderr that
/// begins with "aerostat: ". An empty sink silences the library. This function must be called
/// before other threads run.
LogSink set_log_sink(LogSink sink);

/// Tells the user something that does not stop the work. This function can be called from any
/// thread.
void warn(const std::string& message);

}  // namespace aerostat
