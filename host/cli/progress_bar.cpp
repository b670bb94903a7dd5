#include "cli/progress_bar.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "core/environment.hpp"

namespace aerostat::cli {

namespace {

constexpr double kRedrawSeconds = 0.1;
constexpr double kLineSeconds = 5.0;
constexpr double kLeastLineSeconds = 1.0;
constexpr double kLineFraction = 0.1;

// The least time and fraction from which a rate and the time left are estimated. Estimates from
// less are unsteady. Chosen by eye.
constexpr double kLeastMeasureSeconds = 0.3;
constexpr double kLeastMeasureFraction = 0.02;

int stderr_columns() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

}  // namespace

ProgressStyle stderr_style(bool quiet) {
  ProgressStyle style;
  if (quiet) return style;
  const bool is_dumb = environment_variable("TERM").value_or("dumb") == "dumb";
  const bool is_terminal = ::isatty(STDERR_FILENO) == 1 && !is_dumb;
  style.mode = is_terminal ? ProgressStyle::Mode::terminal : ProgressStyle::Mode::lines;
  style.color = is_terminal && !environment_variable("NO_COLOR");
  style.columns = stderr_columns;
  return style;
}

ProgressBar::ProgressBar(ProgressStyle style, Write write)
    : style_(std::move(style)), write_(std::move(write)) {}

ProgressBar::~ProgressBar() {
  clear();
}

ProgressView ProgressBar::view_of(const render::Progress& progress) {
  const double elapsed = progress.seconds - stage_began_s_;
  ProgressView view{progress.stage, progress.fraction, 0.0, std::nullopt, label_, elapsed};
  if (progress.stage != render::Stage::rays || elapsed < kLeastMeasureSeconds) return view;
  view.rays_per_s = static_cast<double>(progress.rays) / elapsed;
  if (progress.fraction >= kLeastMeasureFraction) {
    view.seconds_left = elapsed * (1.0 - progress.fraction) / progress.fraction;
  }
  return view;
}

bool ProgressBar::is_line_due(const render::Progress& progress) const {
  const double waited = progress.seconds - last_s_;
  const bool has_advanced =
      progress.stage == render::Stage::rays && progress.fraction - last_fraction_ >= kLineFraction;
  return waited >= kLineSeconds || (has_advanced && waited >= kLeastLineSeconds);
}

void ProgressBar::update(const render::Progress& progress) {
  const std::lock_guard lock(mutex_);
  if (style_.mode == ProgressStyle::Mode::none) return;
  const bool is_new_stage = is_first_ || progress.stage != stage_;
  if (is_new_stage) {
    stage_ = progress.stage;
    stage_began_s_ = progress.seconds;
    last_fraction_ = 0.0;
  }
  if (progress.stage == render::Stage::done) return erase();
  const bool is_terminal = style_.mode == ProgressStyle::Mode::terminal;
  const bool is_due = is_terminal ? is_new_stage || progress.seconds - last_s_ >= kRedrawSeconds
                                  : is_line_due(progress);
  is_first_ = false;
  if (!is_due) return;
  last_s_ = progress.seconds;
  last_fraction_ = progress.fraction;
  if (is_terminal) {
    write_(fmt::format("\r{}\x1b[K",
                       terminal_line(view_of(progress), style_.columns(), style_.color)));
    is_shown_ = true;
  } else {
    write_(fmt::format("{}\n", plain_line(view_of(progress))));
  }
}

void ProgressBar::set_label(std::string label) {
  const std::lock_guard lock(mutex_);
  label_ = std::move(label);
}

void ProgressBar::message(std::string_view text) {
  const std::lock_guard lock(mutex_);
  erase();
  write_(fmt::format("{}\n", text));
}

void ProgressBar::clear() {
  const std::lock_guard lock(mutex_);
  erase();
}

void ProgressBar::erase() {
  if (is_shown_) write_("\r\x1b[K");
  is_shown_ = false;
}

}  // namespace aerostat::cli
