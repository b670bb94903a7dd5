#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <string_view>

#include "cli/progress_text.hpp"
#include "render/session.hpp"

namespace aerostat::cli {

/// How progress is shown.
struct ProgressStyle {
  enum class Mode {
    none,      ///< not at all
    lines,     ///< a line each 10 % of the tracing or 5 seconds, at most one a second
    terminal,  ///< one line that is written over, at most ten times a second
  };
  Mode mode = Mode::none;
  bool color = false;
  std::function<int()> columns = [] { return 80; };
};

/// The style that suits stderr: `terminal` if it is one that can move its cursor, coloured unless
/// NO_COLOR is set (no-color.org); else `lines`; `none` if quiet.
ProgressStyle stderr_style(bool quiet);

/// Shows a render's progress. Safe from any thread.
class ProgressBar {
 public:
  using Write = std::function<void(std::string_view)>;

  ProgressBar(ProgressStyle style, Write write);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void update(const render::Progress& progress);

  /// What is shown in place of the stage from the next update on.
  void set_label(std::string label);

  /// Writes a message in a line of its own; the bar comes back below it with the next update.
  void message(std::string_view text);

  /// Takes the bar away.
  void clear();

 private:
  ProgressView view_of(const render::Progress& progress);
  bool is_line_due(const render::Progress& progress) const;
  void erase();

  std::mutex mutex_;
  ProgressStyle style_;
  Write write_;
  std::string label_;
  bool is_shown_ = false;
  bool is_first_ = true;
  render::Stage stage_ = render::Stage::world;
  double stage_began_s_ = 0.0;
  double last_s_ = 0.0;
  double last_fraction_ = 0.0;
};

}  // namespace aerostat::cli
