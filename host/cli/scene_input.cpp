#include "cli/scene_input.hpp"

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "cli/parse.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/log.hpp"
#include "elevation/open.hpp"
#include "scene/installed.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "scene/source.hpp"
#include "staging/map_stage.hpp"
#include "staging/scene_text.hpp"
#include "staging/stage.hpp"
#include "world/resolve.hpp"

namespace aerostat::cli {

namespace {

constexpr const char* kStandardInput = "standard input";
constexpr std::size_t kMostBytes = std::size_t{32} << 20;  // more than the largest allowed scene

std::string text_of_stdin() {
  std::string text;
  std::vector<char> chunk(std::size_t{1} << 16);
  while (text.size() < kMostBytes) {
    const ssize_t count = ::read(STDIN_FILENO, chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      throw Error(ErrorKind::io, fmt::format("{}: cannot read the scene: {}", kStandardInput,
                                             std::generic_category().message(errno)));
    }
    if (count == 0) break;
    text.append(chunk.data(), static_cast<std::size_t>(count));
  }
  return text;
}

/// Returns whether the scene is named by a bare file or folder of elevation data.
bool is_land(const SceneOptions& options) {
  if (is_standard(options.scene) || options.scene.extension() == ".json") return false;
  return scene::find_scene(options.scene) == options.scene &&
         elevation::is_elevation(options.scene);
}

/// Returns the text of standard input if the scene comes from there.
std::string text_of(const SceneOptions& options) {
  return is_standard(options.scene) ? text_of_stdin() : std::string();
}

/// Reads a scene that is no bare file of heights.
scene::Scene plain_scene(const SceneOptions& options, const std::string& text) {
  const std::vector<scene::Override> overrides = overrides_of(options);
  if (is_standard(options.scene)) return scene::read_text(text, kStandardInput, overrides);
  const std::filesystem::path file = scene::find_scene(options.scene);
  staging::require_scene_text(file);
  const auto files = options.allow_external_paths ? scene::NamedFiles::anywhere
                                                  : scene::NamedFiles::below_the_scene;
  return scene::read_file(file, overrides, files);
}

/// Reads the scene in a form that can be edited. Its messages name neither lines nor options, so
/// that plain_scene() must have found no fault.
scene::SceneSource source_of(const SceneOptions& options, const std::string& text) {
  const auto source = [&] {
    if (is_land(options)) return staging::scene_around(options.scene);
    if (is_standard(options.scene)) return scene::SceneSource::from_text(text, kStandardInput);
    return scene::SceneSource::from_file(scene::find_scene(options.scene));
  };
  return source().with(overrides_of(options));
}

/// Refuses to write to the scene's own file, whatever its name, because the output would destroy
/// it.
void refuse_own_input(const std::filesystem::path& output, const SceneOptions& input) {
  const std::filesystem::path scene =
      is_standard(input.scene) ? "/dev/stdin" : scene::find_scene(input.scene);
  if (!is_same_file(output, scene)) return;
  throw Error(ErrorKind::usage, fmt::format("--output: '{}' is the scene file '{}' itself, which "
                                            "would be lost; give another name",
                                            output.string(), name_of_scene(input)));
}

}  // namespace

std::vector<scene::Override> overrides_of(const SceneOptions& options) {
  std::vector<scene::Override> overrides;
  for (const std::string& text : options.overrides) {
    overrides.push_back(scene::parse_override(text));
  }
  return overrides;
}

staging::Staged read_staged(const SceneOptions& options, world::ReliefCache& reliefs,
                            Staging staging) {
  const scene::SceneSource source = read_source(options);
  return staging == Staging::map ? staging::stage_map(source, reliefs)
                                 : staging::stage(source, reliefs);
}

scene::Scene read_scene(const SceneOptions& options, world::ReliefCache& reliefs, Staging staging) {
  const staging::Staged staged = read_staged(options, reliefs, staging);
  for (const std::string& note : staged.notes) warn(note);
  return staged.source.scene();
}

scene::SceneSource read_source(const SceneOptions& options) {
  const std::string text = text_of(options);
  if (!is_land(options)) plain_scene(options, text);
  return source_of(options, text);
}

std::string name_of_scene(const SceneOptions& options) {
  return is_standard(options.scene) ? kStandardInput : options.scene.string();
}

scene::ResolvedScene resolve_scene(const scene::Scene& scene, const SceneOptions& options,
                                   world::ReliefCache& reliefs) {
  try {
    return world::resolve(scene, reliefs);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_data) throw;
    throw Error(error.kind(), fmt::format("{}: {}", name_of_scene(options), error.what()));
  }
}

scene::ResolvedScene load_scene(const SceneOptions& options, world::ReliefCache& reliefs) {
  return resolve_scene(read_scene(options, reliefs), options, reliefs);
}

std::filesystem::path output_file(const std::filesystem::path& output, const SceneOptions& input,
                                  bool is_binary) {
  const std::filesystem::path file = is_standard(output) ? "/dev/stdout" : output;
  if (file == "/dev/stdout" && is_binary && ::isatty(STDOUT_FILENO) == 1) {
    throw Error(ErrorKind::usage,
                "--output: standard output is a terminal, which cannot show a binary file; "
                "redirect it, such as > picture.png");
  }
  require_writable(file);
  refuse_own_input(file, input);
  return file;
}

std::string name_of_output(const std::filesystem::path& output) {
  return output == "/dev/stdout" ? "standard output" : output.string();
}

void write_stdout(const std::string& text) {
  write_file("/dev/stdout", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace aerostat::cli
