#include <cstdio>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/land_report.hpp"
#include "cli/scene_input.hpp"
#include "cli/track_report.hpp"
#include "core/error.hpp"
#include "film/timeline.hpp"
#include "film/way.hpp"
#include "staging/stage.hpp"
#include "track/read.hpp"
#include "world/scene_models.hpp"

namespace aerostat::cli {

namespace {

int check_track(const CheckOptions& options) {
  if (!options.input.overrides.empty()) {
    throw Error(ErrorKind::usage, fmt::format("--set: '{}' is a track, which has no values to set; "
                                              "expected a scene",
                                              options.input.scene.string()));
  }
  const std::string name = options.input.scene.string();
  const track::Cleaned cleaned = track::clean(track::read_file(options.input.scene));
  const track::Flight flight = track::fit_heights(cleaned.track, {});
  write_stdout(options.json ? track_json(name, cleaned, flight)
                            : track_text(name, cleaned, flight));
  return 0;
}

}  // namespace

int check(const CheckOptions& options) {
  if (track::is_track(options.input.scene)) return check_track(options);
  const std::string name = name_of_scene(options.input);
  world::ReliefCache reliefs;
  const staging::Staged staged = read_staged(options.input, reliefs);
  const scene::ResolvedScene scene = resolve_scene(staged.source.scene(), options.input, reliefs);
  world::ModelCache().models_of(*scene);
  if (staged.land != nullptr) {
    write_stdout(options.json ? land_json(name, staged) : land_text(name, staged));
  } else if (options.json) {
    throw Error(ErrorKind::usage,
                fmt::format("--json: '{}' is no track and has no elevation data; only these have a "
                            "report in JSON",
                            name));
  }
  if (staged.source.gives("/film") && !options.json) {
    film::Timeline timeline(staged.source, reliefs);
    write_stdout(film::way_text(timeline));
  }
  fmt::print(stderr, "{}: ok\n", name);
  return 0;
}

}  // namespace aerostat::cli
