#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace aerostat::bench {

/// Returns the median of a list that is not empty.
double median(std::vector<double> values);

/// Returns the figures of a bench as a table for people. The JSON holds the same figures.
std::string table(const nlohmann::ordered_json& figures);

}  // namespace aerostat::bench
