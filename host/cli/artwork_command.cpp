#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

#include "artwork/template.hpp"
#include "cli/commands.hpp"
#include "cli/parse.hpp"
#include "cli/scene_input.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "scene/scene.hpp"

namespace aerostat::cli {
namespace {

/// Returns the scene of the command line, or one with all defaults.
scene::Scene scene_of(const SceneOptions& options) {
  if (!options.scene.empty()) return read_source(options).scene();
  return scene::read_text("{\"version\": 1}", "--set", overrides_of(options));
}

/// Returns the balloon of this number, 0 being /balloon.
const scene::Balloon& balloon_of(const scene::Scene& scene, int number) {
  if (number == 0) return scene.balloon;
  const auto index = static_cast<std::size_t>(number - 1);
  if (index < scene.balloons.size()) return scene.balloons[index];
  throw Error(ErrorKind::usage,
              fmt::format("--balloon: found {}, expected at most {}, the number of "
                          "balloons in /balloons",
                          number, scene.balloons.size()));
}

std::filesystem::path checked_output(const ArtworkOptions& options) {
  if (!is_standard(options.output) && options.output.extension() != ".svg") {
    throw Error(ErrorKind::usage, fmt::format("--output: the template is an .svg file, not '{}'",
                                              options.output.string()));
  }
  if (!options.input.scene.empty()) return output_file(options.output, options.input, false);
  if (is_standard(options.output)) return "/dev/stdout";
  require_writable(options.output);
  return options.output;
}

}  // namespace

int make_artwork(const ArtworkOptions& options) {
  const std::filesystem::path output = checked_output(options);
  const scene::Scene scene = scene_of(options.input);
  const std::string text = artwork::gores_template(balloon_of(scene, options.balloon));
  write_file(output, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  if (!is_standard(options.output)) fmt::print(stderr, "wrote {}\n", output.string());
  return 0;
}

}  // namespace aerostat::cli
