#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace aerostat::elevation {

/// Returns a zip file with members of these names and contents. Method 0 stores them; any other
/// deflates them and is written as it is.
std::string zip(const std::vector<std::pair<std::string, std::string>>& members, int method = 8,
                int flags = 0);

/// Returns a gzip file.
std::string gzip(const std::string& bytes);

}  // namespace aerostat::elevation
