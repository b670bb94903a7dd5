#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "scene/io.hpp"
#include "scene/resolved_scene.hpp"
#include "scene/source.hpp"
#include "staging/stage.hpp"
#include "world/surface.hpp"

/// These functions read the input of all commands and write data to stdout.
namespace aerostat::cli {

/// What a scene on real land without a camera becomes.
enum class Staging { view, map };

/// Reads the scene and applies the overrides. A bare file or folder of elevation data becomes a
/// scene around it. What a scene on real land leaves open is chosen. Throws the errors of
/// scene::read_file and staging::stage.
staging::Staged read_staged(const SceneOptions& options, world::ReliefCache& reliefs,
                            Staging staging = Staging::view);

/// Reads the scene as read_staged() does, and prints what was found and chosen.
scene::Scene read_scene(const SceneOptions& options, world::ReliefCache& reliefs,
                        Staging staging = Staging::view);

/// Reads the scene as read_scene() does, in a form that can be edited, and chooses nothing.
scene::SceneSource read_source(const SceneOptions& options);

/// Returns the changes of --set.
std::vector<scene::Override> overrides_of(const SceneOptions& options);

/// Returns the name of the scene for messages.
std::string name_of_scene(const SceneOptions& options);

/// Resolves a scene that was read by `options`. Throws the errors of world::resolve. A message
/// about the scene's data begins with the scene's name.
scene::ResolvedScene resolve_scene(const scene::Scene& scene, const SceneOptions& options,
                                   world::ReliefCache& reliefs);

/// Reads the scene, applies the overrides and resolves it. Throws the errors of read_scene and
/// resolve_scene.
scene::ResolvedScene load_scene(const SceneOptions& options, world::ReliefCache& reliefs);

/// Returns the file to write for a name on the command line, which is standard output for "-".
/// Throws Error{usage} if standard output is a terminal and `is_binary` is true. Throws
/// Error{usage} if the file is the scene file under any name, because the output would destroy
/// it. Throws the errors of require_writable.
std::filesystem::path output_file(const std::filesystem::path& output, const SceneOptions& input,
                                  bool is_binary);

/// Returns the name of an output for messages.
std::string name_of_output(const std::filesystem::path& output);

/// Writes data to stdout. Throws Error{io} if the data cannot be written.
void write_stdout(const std::string& text);

}  // namespace aerostat::cli
