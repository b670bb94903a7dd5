#pragma once

#include <span>
#include <string>
#include <vector>

#include "land/land.hpp"

namespace aerostat::land {

/// Returns a sentence that warns of files whose heights count from different levels, or nothing.
/// Files that do not say their level are passed over.
std::string datum_note(std::span<const elevation::RasterInfo> files);

/// Returns what a user should know of the files, in whole sentences: what was guessed, what was
/// mended and what stands out.
std::vector<std::string> notes_about(const Land& land);

}  // namespace aerostat::land
