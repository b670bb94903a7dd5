#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "core/land_cover.hpp"

namespace aerostat::land {

/// The classes of codes. Codes that are not in the map are unknown.
using CoverCodes = std::map<int, CoverClass>;

/// How often each code occurs.
using CoverCounts = std::map<int, std::uint64_t>;

/// The codes of a raster with their classes, and a sentence for the user on how they were taken.
struct KnownCodes {
  CoverCodes classes;
  std::string note;
};

/// Returns the classes of the codes that occur in `file`. `own` are those that the user gives,
/// which win. Throws Error{bad_data} that lists the codes if the scheme does not know one, or if it
/// is automatic and none knows all.
KnownCodes known_codes(CoverScheme scheme, const CoverCodes& own, const CoverCounts& found,
                       const std::filesystem::path& file);

}  // namespace aerostat::land
