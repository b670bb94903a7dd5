#pragma once

#include <filesystem>
#include <vector>

namespace aerostat::land {

/// Returns the files that are named, and those with known suffixes in folders that are named.
/// Throws Error{io} if one does not exist, and Error{bad_data} if a folder holds no file of heights
/// or if there are too many.
std::vector<std::filesystem::path> source_files(const std::vector<std::filesystem::path>& sources);

}  // namespace aerostat::land
