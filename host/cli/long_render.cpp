#include "cli/long_render.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cli/progress_text.hpp"
#include "cli/render_traits.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/log.hpp"
#include "scene/scene.hpp"

namespace aerostat::cli {
namespace {

namespace fs = std::filesystem;

/// The time that a render has to come to a pause before it is ended.
constexpr int kPauseGrace_ms = 10'000;

void require_apart(const fs::path& checkpoint, const fs::path& output, const SceneOptions& input) {
  const bool is_output = checkpoint.lexically_normal() == output.lexically_normal() ||
                         is_same_file(checkpoint, output);
  if (!is_output && !is_same_file(checkpoint, input.scene)) return;
  throw Error(ErrorKind::usage, fmt::format("--checkpoint: '{}' is also the {}; give another name",
                                            checkpoint.string(), is_output ? "picture" : "scene"));
}

}  // namespace

LongRender::LongRender(const RenderOptions& options, const fs::path& output, Interrupt& interrupt,
                       ProgressBar& bar, const Stopwatch& watch)
    : options_(options), interrupt_(interrupt), bar_(bar), watch_(watch) {
  if (options.checkpoint.empty()) return;
  require_apart(options.checkpoint, output, options.input);
  if (is_special_file(options.checkpoint)) {
    throw Error(ErrorKind::usage,
                fmt::format("--checkpoint: '{}' is no regular file", options.checkpoint.string()));
  }
  require_writable(options.checkpoint);
}

std::shared_ptr<const render::FilmSums> LongRender::begin(const render::Session& session,
                                                          const scene::ResolvedScene& scene,
                                                          render::Contents contents, bool guides) {
  if (options_.checkpoint.empty()) return nullptr;
  const scene::Image& image = scene->image;
  const render::Crop part = options_.crop.value_or(render::Crop{0, 0, image.width, image.height});
  traits_ = traits_of(*scene, part, session.lanes(), contents, guides);
  auto sums = render::read_checkpoint(options_.checkpoint, traits_,
                                      session.film_window(image, options_.crop), image.spp, guides);
  if (!sums) return nullptr;
  if (!options_.quiet) {
    bar_.message(fmt::format("going on from '{}' at {} of {} spp", options_.checkpoint.string(),
                             sums->samples_done, image.spp));
  }
  return std::make_shared<const render::FilmSums>(std::move(*sums));
}

image::Film LongRender::render(render::Session& session, const scene::ResolvedScene& scene,
                               render::Contents contents, bool guides) {
  samples_ = scene->image.spp;
  render::Course course;
  course.from = begin(session, scene, contents, guides);
  if (saves() || options_.time_limit_s > 0.0) {
    course.wants_pause = [this](const render::Progress& now) { return wants_pause(now); };
    course.at_pause = [this](const render::Pause& pause) { return at_pause(pause); };
  }
  const std::stop_callback ending(interrupt_.token(), [this] {
    if (!pauses_) hard_.request_stop();
  });
  return session.render_on(
      scene, course, hard_.get_token(),
      [this](const render::Progress& progress) { bar_.update(progress); }, options_.crop);
}

bool LongRender::is_time_over() const {
  return options_.time_limit_s > 0.0 && watch_.seconds() >= options_.time_limit_s;
}

bool LongRender::wants_pause(const render::Progress& progress) {
  if (saves() && !pauses_.exchange(true)) {
    since_save_.restart();
    interrupt_.set_grace(kPauseGrace_ms);
    // The signal may have come before the callback could know that the render pauses for it.
    if (is_interrupted()) hard_.request_stop();
  }
  if (saves() && is_interrupted()) {
    if (!std::exchange(is_told_, true)) {
      bar_.message("aerostat: interrupted; saving what is done (a second signal ends at once)");
    }
    return true;
  }
  // The first pass is always finished, so that there is a picture and repeated calls come to an
  // end.
  if (is_time_over() && progress.samples_done > 0) return true;
  return !options_.checkpoint.empty() && since_save_.seconds() >= options_.checkpoint_every_s;
}

bool LongRender::at_pause(const render::Pause& pause) {
  const bool is_stopped = saves() && is_interrupted();
  is_ended_ = is_stopped || (is_time_over() && pause.is_picture);
  if (is_stopped) interrupt_.set_grace(Interrupt::kNoLimit);
  if (!options_.checkpoint.empty()) save(pause, is_ended_);
  if (!is_ended_) return true;
  missing_ = fmt::format("{} of {} spp", pause.samples_done, samples_);
  if (!is_stopped || (options_.save_partial && pause.is_picture)) return false;
  const std::string reason =
      options_.save_partial ? "before each pixel had a sample" : "at " + missing_;
  throw Error(ErrorKind::interrupted, fmt::format("interrupted {}{}", reason, way_on()));
}

/// Saves the checkpoint. A failure in the middle of a render is said once, and the render goes on.
void LongRender::save(const render::Pause& pause, bool is_end) {
  try {
    render::write_checkpoint(options_.checkpoint, traits_, pause.sums());
  } catch (const Error& error) {
    if (is_end || error.kind() != ErrorKind::io) throw;
    if (!std::exchange(is_failing_told_, true)) {
      warn(fmt::format("{}; the render goes on, and tries again", error.what()));
    }
  }
  since_save_.restart();
}

std::stop_token LongRender::token() const {
  return options_.save_partial ? std::stop_token() : interrupt_.token();
}

std::string LongRender::way_on() const {
  if (options_.checkpoint.empty()) return "; nothing is saved";
  return fmt::format("; '{}' holds what is done, and the same command goes on",
                     options_.checkpoint.string());
}

void LongRender::finish(const std::string& picture) const {
  if (!is_ended_) {
    std::error_code ignored;
    if (!options_.checkpoint.empty()) fs::remove(options_.checkpoint, ignored);
    return;
  }
  const std::string shows = fmt::format("{} shows {}", picture, missing_);
  const std::string on = options_.checkpoint.empty() ? "" : "; the same command goes on";
  if (is_interrupted()) {
    throw Error(ErrorKind::interrupted, fmt::format("interrupted; {}{}", shows, on));
  }
  if (options_.checkpoint.empty()) return;
  throw Error(ErrorKind::exhausted, fmt::format("the time limit of {} is over; {}{}",
                                                duration_text(options_.time_limit_s), shows, on));
}

}  // namespace aerostat::cli
