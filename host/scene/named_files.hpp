#pragma once

#include <string>
#include <vector>

namespace aerostat::scene {

struct Scene;

/// Returns the names of all files and folders that a scene names itself, in the order of the scene:
/// elevation data, pictures and land cover on the ground, flight tracks, pictures and models of
/// envelopes, models, and species of plants. Files that these files name are not among them. The
/// names may be changed.
std::vector<std::string*> named_files(Scene& scene);

}  // namespace aerostat::scene
