#pragma once

#include <string>

#include "track/clean.hpp"
#include "track/flight.hpp"

/// These functions describe a track in words and in JSON.
namespace aerostat::cli {

/// Returns the lines of a report, each with a line end. `name` is the file's name.
std::string track_text(const std::string& name, const track::Cleaned& cleaned,
                       const track::Flight& flight);

/// Returns the same figures as JSON with a line end.
std::string track_json(const std::string& name, const track::Cleaned& cleaned,
                       const track::Flight& flight);

}  // namespace aerostat::cli
