#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <string_view>

#include "cli/progress_text.hpp"
#include "render/session.hpp"

namespace aerostat::cli {

/// The way in which progress is shown.
struct ProgressStyle {
  enum class Mode {
    none,      ///< no progress is shown
    lines,     ///< a line each 10 % of the tracing or 5 seconds, at most one a second
    terminal,  ///< one line that is rewritten, at most ten times a second
  };
  Mode mode = Mode::none;
  bool color = false;
  std::function<int()> columns = [] { return 80; };
};

/// Returns the style that suits stderr. It is `none` if `quiet` is true. It is `terminal` if
/// stderr is a terminal that can move its cursor, with colours unless NO_COLOR is set
/// (no-color.org). Otherwise it is `lines`.
ProgressStyle stderr_style(bool quiet);

/// Shows the progress of a render. All functions can be called from any thread.
class ProgressBar {
 public:
  using Write = std::function<void(std::string_view)>;

  ProgressBar(ProgressStyle style, Write write);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void update(const render::Progress& progress);

  /// Sets the text that is shown in place of the stage from the next update on.
  void set_label(std::string label);

  /// Writes a message in a line of its own. The bar comes back below it with the next update.
  void message(std::string_view text);

  /// Removes the bar from the terminal.
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
