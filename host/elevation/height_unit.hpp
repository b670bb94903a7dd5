#pragma once

#include <optional>
#include <string>

namespace aerostat::elevation {

/// A unit of heights.
struct HeightUnit {
  double metres = 1.0;
  const char* name = "metre";
};

/// Returns the unit that a name such as "m", "ft" or "US survey foot" stands for, in any case of
/// its letters.
std::optional<HeightUnit> height_unit_of(const std::string& name);

/// Returns the name of a unit of so many metres, or nothing for an unusual one.
std::optional<HeightUnit> height_unit_of(double metres);

}  // namespace aerostat::elevation
