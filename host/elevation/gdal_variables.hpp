#pragma once

#include <string>
#include <vector>

namespace aerostat::elevation {

/// Returns the names of the variables in a file of several rasters, as the program gdalinfo prints
/// them. Names with unusual characters are left out.
std::vector<std::string> variables_in(const std::string& gdalinfo);

/// Returns which variable holds heights: the one that the user names, or the only one, or the one
/// with the most usual name. Returns an empty text if none stands out.
std::string variable_of_heights(const std::vector<std::string>& variables,
                                const std::string& wanted);

/// Returns the part of a name behind its groups: "dem" of "//land/dem".
std::string last_part(const std::string& variable);

/// Returns whether the program gdalinfo prints that a raster counts downwards, as depths do.
bool counts_downwards(const std::string& gdalinfo);

}  // namespace aerostat::elevation
