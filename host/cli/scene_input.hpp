#pragma once

#include <string>

#include "cli/options.hpp"
#include "scene/scene.hpp"

/// What the commands share: their input and their data on stdout.
namespace aerostat::cli {

/// Reads the scene and applies the overrides. Throws as scene::read_file does.
scene::Scene read_scene(const SceneOptions& options);

/// Reads the scene, applies the overrides and resolves it. Throws as scene::read_file and
/// world::resolve do.
scene::Scene load_scene(const SceneOptions& options);

/// Writes data to stdout; throws Error{io} if it does not arrive.
void write_stdout(const std::string& text);

}  // namespace aerostat::cli
