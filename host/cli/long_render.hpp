#pragma once

#include <atomic>
#include <memory>
#include <stop_token>
#include <string>

#include "cli/interrupt.hpp"
#include "cli/options.hpp"
#include "cli/progress_bar.hpp"
#include "core/stopwatch.hpp"
#include "image/film.hpp"
#include "render/checkpoint.hpp"
#include "render/session.hpp"
#include "scene/resolved_scene.hpp"

namespace aerostat::cli {

/// A render that may end early with the picture so far, and whose sums may be saved so that the
/// same command goes on with them: the options --time-limit, --save-partial and --checkpoint.
class LongRender {
 public:
  /// Throws as require_writable does if the checkpoint cannot be written, and Error{usage} if it is
  /// also the picture. `watch` began with the command.
  LongRender(const RenderOptions& options, const std::filesystem::path& output,
             Interrupt& interrupt, ProgressBar& bar, const Stopwatch& watch);

  /// Renders, and goes on with the sums of the checkpoint if there are any. Throws
  /// Error{interrupted} after an interrupt if no picture is to be saved.
  image::Film render(render::Session& session, const scene::ResolvedScene& scene,
                     render::Contents contents, bool guides);

  /// Returns a token for the work after the render. Of a picture that is saved although the render
  /// was interrupted, it asks for no stop.
  std::stop_token token() const;

  /// Returns what the film has in place of all samples, such as "7 of 64 spp", or an empty text if
  /// it is whole.
  const std::string& missing() const { return missing_; }

  /// Ends the command after the picture was written. Removes the checkpoint of a whole picture.
  /// Throws Error{interrupted} after an interrupt, and Error{exhausted} after a time limit if the
  /// same command would go on.
  void finish(const std::string& picture) const;

 private:
  bool saves() const { return options_.save_partial || !options_.checkpoint.empty(); }
  bool is_interrupted() const { return interrupt_.token().stop_requested(); }
  bool is_time_over() const;
  bool wants_pause(const render::Progress& progress);
  bool at_pause(const render::Pause& pause);
  void save(const render::Pause& pause, bool is_end);
  std::shared_ptr<const render::FilmSums> begin(const render::Session& session,
                                                const scene::ResolvedScene& scene,
                                                render::Contents contents, bool guides);
  std::string way_on() const;

  const RenderOptions& options_;
  Interrupt& interrupt_;
  ProgressBar& bar_;
  const Stopwatch& watch_;
  render::Traits traits_;
  int samples_ = 0;
  Stopwatch since_save_;
  /// Whether an interrupt is answered by a pause.
  std::atomic<bool> pauses_ = false;
  bool is_told_ = false;
  bool is_failing_told_ = false;
  bool is_ended_ = false;
  std::stop_source hard_;
  std::string missing_;
};

}  // namespace aerostat::cli
