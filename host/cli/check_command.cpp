#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "artwork/check.hpp"
#include "cli/commands.hpp"
#include "cli/land_report.hpp"
#include "cli/memory_report.hpp"
#include "cli/scene_input.hpp"
#include "cli/track_report.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "film/timeline.hpp"
#include "film/way.hpp"
#include "staging/flight_of.hpp"
#include "staging/stage.hpp"
#include "track/read.hpp"
#include "world/scene_models.hpp"

namespace aerostat::cli {

namespace {

/// Returns the land of a file or folder, null without a name.
std::shared_ptr<const land::Land> land_below(const std::filesystem::path& file) {
  if (file.empty()) return nullptr;
  auto land = staging::land_of(file);
  if (land->has_place()) return land;
  throw Error(ErrorKind::bad_data,
              fmt::format("--land: '{}' does not say where on the Earth it lies", file.string()));
}

int check_track(const CheckOptions& options) {
  if (!options.input.overrides.empty()) {
    throw Error(ErrorKind::usage, fmt::format("--set: '{}' is a track, which has no values to set; "
                                              "expected a scene",
                                              options.input.scene.string()));
  }
  const std::string name = options.input.scene.string();
  const track::Cleaned cleaned = track::clean(track::read_file(options.input.scene));
  const std::shared_ptr<const land::Land> land = land_below(options.land);
  track::Ground ground;
  if (land != nullptr) {
    ground = staging::ground_around(*land, cleaned.track.segments.front().front().place);
  }
  track::FitOptions fit;
  fit.clearance_m = staging::kClearance_m;
  const track::Flight flight = track::fit_heights(cleaned.track, ground, fit);
  write_stdout(options.json ? track_json(name, cleaned, flight)
                            : track_text(name, cleaned, flight));
  return 0;
}

/// Prints what memory a render of the scene needs. Throws Error{exhausted} if a device has less.
void check_memory(const CheckOptions& options, const scene::ResolvedScene& scene) {
  if (options.device.empty()) return;
  render::Options session;
  session.devices = opencl::select_devices(options.device);
  session.contents = render::Contents::picture;
  const render::MemoryNeed need = render::memory_need(scene, session);
  write_stdout(memory_text(need, session.devices));
  for (const opencl::Device& device : session.devices) {
    const std::string bound = device.memory_bound.empty() ? "the device" : device.memory_bound;
    render::require_room(need, device.memory_bytes, bound);
  }
}

}  // namespace

int check(const CheckOptions& options) {
  if (track::is_track(options.input.scene)) return check_track(options);
  if (!options.land.empty()) {
    throw Error(ErrorKind::usage, fmt::format("--land: '{}' is no track; only these are laid over "
                                              "elevation data",
                                              options.input.scene.string()));
  }
  const std::string name = name_of_scene(options.input);
  world::ReliefCache reliefs;
  const staging::Staged staged = read_staged(options.input, reliefs);
  const scene::ResolvedScene scene = resolve_scene(staged.source.scene(), options.input, reliefs);
  world::ModelCache().models_of(*scene);
  for (const std::string& sentence : artwork::check_pictures(*scene)) warn(sentence);
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
  check_memory(options, scene);
  fmt::print(stderr, "{}: ok\n", name);
  return 0;
}

}  // namespace aerostat::cli
