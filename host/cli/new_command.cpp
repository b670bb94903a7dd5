#include <cstdint>
#include <system_error>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/parse.hpp"
#include "cli/scene_input.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/log.hpp"
#include "scene/source.hpp"
#include "staging/stage.hpp"

namespace aerostat::cli {

namespace {

namespace fs = std::filesystem;

/// Returns the name by which a scene file names a file: relative to the scene's folder if the file
/// lies in it, else absolute.
std::string named_from(const fs::path& scene, const fs::path& file) {
  const fs::path whole = fs::absolute(file).lexically_normal();
  const fs::path folder = fs::absolute(scene).lexically_normal().parent_path();
  const fs::path relative = whole.lexically_relative(folder);
  if (relative.empty() || *relative.begin() == "..") return whole.string();
  return relative.string();
}

fs::path output_of(const NewOptions& options) {
  if (!options.output.empty()) return options.output;
  fs::path name = options.input.scene.filename();
  if (name.empty()) name = options.input.scene.parent_path().filename();
  return name.replace_extension(".json");
}

}  // namespace

int new_scene(const NewOptions& options) {
  const fs::path named = output_of(options);
  const fs::path output = output_file(named, options.input, false);
  std::error_code code;
  if (options.output.empty() && fs::exists(output, code)) {
    throw Error(ErrorKind::usage, fmt::format("'{}' exists already; name the new scene by --output",
                                              output.string()));
  }
  world::ReliefCache reliefs;
  const staging::Staged staged =
      staging::stage(staging::scene_around(options.input.scene).with(overrides_of(options.input)),
                     reliefs, options.view - 1);
  for (const std::string& note : staged.notes) warn(note);
  const scene::SceneSource source =
      is_standard(named)
          ? staged.source
          : staged.source.with({{"/terrain/source/0", named_from(output, options.input.scene)}});
  const std::string text = source.text();
  write_file(output, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  if (!is_standard(named)) fmt::print(stderr, "wrote {}\n", output.string());
  if (!is_standard(named) && fs::path(named_from(output, options.input.scene)).is_absolute()) {
    warn(
        fmt::format("the elevation data lie outside of the folder of '{}', so that it needs "
                    "--allow-external-paths",
                    output.string()));
  }
  return 0;
}

}  // namespace aerostat::cli
