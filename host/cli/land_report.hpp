#pragma once

#include <string>

#include "staging/stage.hpp"

/// These functions describe the elevation data of a scene in words and in JSON.
namespace aerostat::cli {

/// Returns the lines of a report, each with a line end: what the files are, what their heights are,
/// and the notes of `staged`, which must have elevation data. `name` is the name of the scene, or
/// of a bare file or folder.
std::string land_text(const std::string& name, const staging::Staged& staged);

/// Returns the same as JSON with a line end. It also has the values that were chosen for the scene.
std::string land_json(const std::string& name, const staging::Staged& staged);

}  // namespace aerostat::cli
