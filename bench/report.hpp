#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace aerostat::bench {

/// The median of a non-empty list.
double median(std::vector<double> values);

/// What a bench found, as a table for people. The JSON holds the same figures.
std::string table(const nlohmann::ordered_json& figures);

}  // namespace aerostat::bench
