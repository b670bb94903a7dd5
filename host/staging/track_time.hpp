#pragma once

#include <string>

namespace aerostat::staging {

/// Returns the seconds since 1970 of a time that a scene's track has under `key`. Throws
/// Error{bad_data} if the text is no time.
double track_time(const std::string& text, const char* key);

}  // namespace aerostat::staging
