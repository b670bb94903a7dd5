#pragma once

#include <cstddef>
#include <string>

#include "labels/places.hpp"

namespace aerostat::labels {

inline constexpr std::size_t kMostFileBytes = std::size_t{16} << 20;
inline constexpr std::size_t kMostPlaces = 100'000;
inline constexpr double kHighest_m = 100e3;  // of a place, above and below the sea

/// Returns what is wrong with a place, such as "latitude 95 (expected -90 to 90)", or an empty
/// text.
std::string fault_of(const NamedPlace& place);

/// Throws Error{bad_data} if there are no places.
void require_places(const std::vector<NamedPlace>& places, const std::string& name);

}  // namespace aerostat::labels
