#pragma once

#include <string>
#include <string_view>

namespace aerostat::test {

/// Takes any bytes for a track and makes a flight of them, over a ground and over none. Returns a
/// description of a fault, or an empty string if everything was as promised. `is_read` becomes
/// whether the bytes were a track.
std::string fault_of_track(std::string_view bytes, bool& is_read);

}  // namespace aerostat::test
