#pragma once

#include <string>
#include <vector>

#include "land/land.hpp"

namespace aerostat::land {

/// Returns what a user should know of the files, in whole sentences: what was guessed, what was
/// mended and what stands out.
std::vector<std::string> notes_about(const Land& land);

}  // namespace aerostat::land
