#pragma once

#include <filesystem>
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

/// The scene as messages call it.
std::string name_of_scene(const SceneOptions& options);

/// The file to write for a name on the command line: standard output for "-". Throws Error{usage}
/// if that is a terminal and `is_binary`, or if it is the scene file by whatever name, which the
/// output would destroy, and as require_writable does.
std::filesystem::path output_file(const std::filesystem::path& output, const SceneOptions& input,
                                  bool is_binary);

/// An output as messages call it.
std::string name_of_output(const std::filesystem::path& output);

/// Writes data to stdout; throws Error{io} if it does not arrive.
void write_stdout(const std::string& text);

}  // namespace aerostat::cli
