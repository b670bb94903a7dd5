#pragma once

#include <optional>
#include <string>

namespace aerostat {

/// Returns the seconds of a time such as "90", "90s", "10m" or "1.5h", or nothing if the text is no
/// time above 0.
std::optional<double> duration_s(const std::string& text);

/// The environment variable with the time after which a device that does not answer counts as
/// lost.
inline constexpr const char* kDeviceTimeoutVariable = "AEROSTAT_DEVICE_TIMEOUT";

}  // namespace aerostat
