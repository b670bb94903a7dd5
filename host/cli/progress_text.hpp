#pragma once

#include <optional>
#include <string>

#include "render/session.hpp"

/// Progress in words: pure functions.
namespace aerostat::cli {

/// What a user is shown of a render's progress.
struct ProgressView {
  render::Stage stage = render::Stage::world;
  double fraction = 0.0;               // of the stage
  double rays_per_s = 0.0;             // 0: not known
  std::optional<double> seconds_left;  // of the tracing
  std::string label;                   // stands for the stage's name if not empty
  double stage_seconds = 0.0;          // that the stage has taken so far
};

/// "tracing rays", for instance.
const char* stage_name(render::Stage stage);

/// "8 s", "3:05" or "1:02:03"; rounded to whole seconds.
std::string duration_text(double seconds);

/// "tracing rays  47 %  12.3 Mrays/s  8 s left"; kernels that are not loaded at once but compiled
/// are "compiling kernels (first run only)  37 %  6 s so far".
std::string plain_line(const ProgressView& view);

/// The same with a bar after the stage, at most `columns` - 1 wide: first the bar shrinks and goes,
/// then the rate, then the time left; at last the line is cut. `color` adds escape sequences, which
/// take no width.
std::string terminal_line(const ProgressView& view, int columns, bool color);

}  // namespace aerostat::cli
