#pragma once

#include <optional>
#include <string>

#include "scene/sun_angles.hpp"

namespace aerostat::scene::detail {

/// What a scene file says of the sun in place of its direction.
inline constexpr const char* kSunDateKeys[] = {"date", "time", "latitude_deg", "longitude_deg"};

/// Days since noon (universal time) of 1 January 2000, from a date as 2024-06-21 and a time of day
/// as 06:30, 06:30:15, 06:30Z or 06:30+02:00 (without an offset it is universal time). Nothing if
/// they are written otherwise or do not exist; years 1900 to 2100.
std::optional<double> days_from_2000(const std::string& date, const std::string& time);

/// Where the sun stands, lifted by refraction in mean air. Right to 0.02 degrees for years 1900 to
/// 2100. Source: J. Meeus, "Astronomical Algorithms" (2nd ed., 1998), chapters 12, 13, 25 (lower
/// accuracy) and, for refraction, 16.4.
SunAngles sun_angles_at(double days_from_2000, double latitude_deg, double longitude_deg);

}  // namespace aerostat::scene::detail
