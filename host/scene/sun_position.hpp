#pragma once

#include <optional>
#include <string>

#include "scene/sun_angles.hpp"

namespace aerostat::scene::detail {

/// The keys of a scene file that give the sun by date, time and place instead of a direction.
inline constexpr const char* kSunDateKeys[] = {"date", "time", "latitude_deg", "longitude_deg"};

/// Returns the days since noon (universal time) of 1 January 2000. The date is written as
/// 2024-06-21, and the time of day as 06:30, 06:30:15, 06:30Z or 06:30+02:00. A time without an
/// offset is universal time. Returns nothing if date or time are written otherwise or do not
/// exist, or if the year is not within 1900 to 2100.
std::optional<double> days_from_2000(const std::string& date, const std::string& time);

/// Returns the position of the sun, lifted by refraction in mean air. It is right to 0.02 degrees
/// for the years 1900 to 2100. Source: J. Meeus, "Astronomical Algorithms" (2nd ed., 1998),
/// chapters 12, 13 and 25 (lower accuracy), and formula 16.4 for refraction.
SunAngles sun_angles_at(double days_from_2000, double latitude_deg, double longitude_deg);

}  // namespace aerostat::scene::detail
