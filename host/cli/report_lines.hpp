#pragma once

#include <string>

#include "geo/place.hpp"

/// These functions make the lines of reports on tracks and on elevation data.
namespace aerostat::cli {

/// Returns a line of a report: a name, or nothing, and what is said of it.
std::string report_line(const char* name, const std::string& text);

/// Returns a place such as "46.80000 N, 9.87000 E".
std::string place_text(const geo::Place& place);

}  // namespace aerostat::cli
