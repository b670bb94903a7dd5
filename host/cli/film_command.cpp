#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/parse.hpp"
#include "cli/picture.hpp"
#include "cli/progress_bar.hpp"
#include "cli/progress_text.hpp"
#include "cli/scene_input.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/log.hpp"
#include "core/stopwatch.hpp"
#include "film/film_run.hpp"
#include "film/frames.hpp"
#include "film/timeline.hpp"
#include "render/scene_cache.hpp"
#include "scene/scene.hpp"

namespace aerostat::cli {

namespace {

namespace fs = std::filesystem;
using film::FilmFiles;
using film::Frame;
using film::FrameState;

FilmFiles files_of(const FilmOptions& options) {
  const fs::path given =
      options.output.empty() ? default_picture(options.input.scene, ".mp4") : options.output;
  if (is_standard(given)) {
    throw Error(ErrorKind::usage, "--output: a film does not go to standard output; give a name");
  }
  return film::film_files(given, options.preview);
}

/// Returns the scene with all options applied.
scene::SceneSource source_of(const FilmOptions& options) {
  SceneOptions input = options.input;
  auto& changes = input.overrides;
  if (!options.quality.empty()) changes.push_back("/quality=" + options.quality);
  if (options.width) changes.push_back(fmt::format("/image/width={}", *options.width));
  if (options.height) changes.push_back(fmt::format("/image/height={}", *options.height));
  const scene::SceneSource source = read_source(input);
  return options.preview ? film::preview_of(source) : source;
}

const char* word_of(FrameState state) {
  switch (state) {
    case FrameState::missing:
      return "missing";
    case FrameState::broken:
      return "broken";
    case FrameState::foreign:
      return "foreign";
    case FrameState::kept:
      break;
  }
  return "kept";
}

/// Prints the frames that are not as they should be, and returns the exit code.
int verify(const std::vector<Frame>& frames, const FilmFiles& files, bool is_quiet) {
  std::string lines;
  for (const Frame& frame : frames) {
    if (frame.state == FrameState::kept) continue;
    lines += fmt::format("{} {} {}\n", word_of(frame.state), frame.number,
                         files.names.name(frame.number).string());
  }
  write_stdout(lines);
  const int good = film::count_of(frames, FrameState::kept);
  if (!is_quiet) {
    print_stderr(fmt::format("{} of {} frames are there: {} missing, {} broken, {} foreign\n", good,
                             frames.size(), film::count_of(frames, FrameState::missing),
                             film::count_of(frames, FrameState::broken),
                             film::count_of(frames, FrameState::foreign)));
  }
  return good == static_cast<int>(frames.size()) ? 0 : static_cast<int>(ErrorKind::bad_data);
}

/// Says which files are not kept, and why.
void tell_remade(const std::vector<Frame>& frames) {
  if (const int foreign = film::count_of(frames, FrameState::foreign); foreign > 0) {
    warn(
        fmt::format("{} frames were made from another scene, size or quality, or by another "
                    "version; they are made anew",
                    foreign));
  }
  if (const int broken = film::count_of(frames, FrameState::broken); broken > 0) {
    warn(fmt::format("{} files of frames are damaged; they are made anew", broken));
  }
}

/// Shows the progress of a film.
void show(ProgressBar& bar, const film::FilmProgress& now) {
  if (now.number == 0) {
    bar.set_label("encoding");
    return;
  }
  const bool is_compiling = now.render.stage == render::Stage::kernels;
  const std::string rate =
      now.made > 1 ? fmt::format(", {:.2f} frames/s", now.frames_per_s) : std::string();
  bar.set_label(is_compiling ? ""
                             : fmt::format("frame {}, {} of {}{}", now.number, now.made + 1,
                                           now.to_make, rate));
  render::Progress progress = now.render;
  if (!is_compiling) progress = {render::Stage::rays, now.fraction(), 0, now.seconds, 0};
  progress.seconds = now.seconds;
  bar.update(progress);
}

film::EncoderOptions encoder_options(const FilmOptions& options, const FilmFiles& files,
                                     const scene::Scene& scene) {
  film::EncoderOptions encoder{files.video, options.codec, scene.image.width, scene.image.height,
                               scene.film.fps / options.frames.step};
  if (files.video.empty()) return encoder;
  film::require_encodable(encoder);
  if (options.shard.count > 1) {
    // The film needs the frames of all shards.
    encoder.output.clear();
  } else {
    output_file(files.video, options.input, true);
  }
  return encoder;
}

std::string summary(const FilmFiles& files, std::size_t frames, int made, double seconds) {
  const fs::path what = files.video.empty() ? files.names.pattern() : files.video;
  return fmt::format("wrote {} ({} frames: {} rendered, {} kept) in {}", what.string(), frames,
                     made, static_cast<int>(frames) - made, duration_text(seconds));
}

}  // namespace

int make_film(const FilmOptions& options) {
  const Stopwatch watch;
  const FilmFiles files = files_of(options);
  const Interrupt interrupt;
  ProgressBar bar(stderr_style(options.quiet), print_stderr);
  const WarningsAbove warnings(bar, options.quiet);

  const auto cache = std::make_shared<render::SceneCache>();
  const scene::SceneSource source = source_of(options);
  film::Timeline timeline(source, cache->reliefs);
  for (const std::string& note : timeline.notes()) warn(note);
  const std::vector<int> numbers =
      film::frames_of(options.frames, options.shard, timeline.frames());
  film::FilmTask task{files, encoder_options(options, files, source.scene()), options.time_limit_s,
                      options.shard.count == 1};
  if (options.shard.count > 1) task.files.video.clear();
  const std::vector<Frame> frames = film::survey(timeline, files, numbers, interrupt.token());
  if (options.verify) return verify(frames, files, options.quiet);

  tell_remade(frames);
  render::Options session = session_options_of(
      options.device, self_test_of(source.scene().light, interrupt.token(), bar));
  session.cache = cache;
  const film::FilmOutcome outcome =
      film::make_film(timeline, session, task, frames, interrupt.token(),
                      [&bar](const film::FilmProgress& now) { show(bar, now); });
  bar.clear();
  if (outcome.left > 0) {
    throw Error(ErrorKind::exhausted,
                fmt::format("the time limit of {} is over with {} frames made and {} left; the "
                            "same command goes on",
                            duration_text(options.time_limit_s), outcome.made, outcome.left));
  }
  if (outcome.no_encoder) throw *outcome.no_encoder;
  if (!options.quiet) {
    bar.message(summary(task.files, frames.size(), outcome.made, watch.seconds()));
  }
  return 0;
}

}  // namespace aerostat::cli
