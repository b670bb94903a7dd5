#pragma once

#include <optional>
#include <string>

#include "render/session.hpp"

/// These pure functions describe progress in words.
namespace aerostat::cli {

/// The progress of a render that is shown to a user.
struct ProgressView {
  render::Stage stage = render::Stage::world;
  double fraction = 0.0;               // done share of the stage, 0 to 1
  double rays_per_s = 0.0;             // 0 if it is not known
  std::optional<double> seconds_left;  // time left of the tracing
  std::string label;                   // replaces the stage's name if it is not empty
  double stage_seconds = 0.0;          // time that the stage has taken so far
};

/// Returns the name of a stage, such as "tracing rays".
const char* stage_name(render::Stage stage);

/// Returns a duration such as "8 s", "3:05" or "1:02:03", rounded to whole seconds.
std::string duration_text(double seconds);

/// Returns a line such as "tracing rays  47 %  12.3 Mrays/s  8 s left". The line of kernels that
/// are compiled, not loaded, is "compiling kernels (first run only)  37 %  6 s so far".
std::string plain_line(const ProgressView& view);

/// Returns the text of plain_line with a bar after the stage, at most `columns` - 1 wide. If
/// there is too little room, the bar shrinks and vanishes first, then the rate, then the time
/// left. At last the line is cut. `color` adds escape sequences, which take up no width.
std::string terminal_line(const ProgressView& view, int columns, bool color);

}  // namespace aerostat::cli
