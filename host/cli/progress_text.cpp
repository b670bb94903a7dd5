#include "cli/progress_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "render/kernel_progress.hpp"

namespace aerostat::cli {

namespace {

constexpr int kWidestBar = 40;
constexpr int kNarrowestBar = 6;

bool is_compiling(const ProgressView& view) {
  return view.stage == render::Stage::kernels && view.stage_seconds >= render::kLeastCompileSeconds;
}

std::string head_of(const ProgressView& view) {
  if (!view.label.empty()) return view.label;
  return fmt::format("{}{}", stage_name(view.stage), is_compiling(view) ? " (first run only)" : "");
}

std::string percent(const ProgressView& view) {
  return fmt::format("{:3.0f} %", std::floor(100.0 * std::clamp(view.fraction, 0.0, 1.0)));
}

std::string rate(const ProgressView& view) {
  return view.rays_per_s > 0.0 ? fmt::format("  {:.1f} Mrays/s", view.rays_per_s * 1e-6) : "";
}

std::string left(const ProgressView& view) {
  if (is_compiling(view)) return fmt::format("  {} so far", duration_text(view.stage_seconds));
  return view.seconds_left ? fmt::format("  {} left", duration_text(*view.seconds_left)) : "";
}

std::string bar(double fraction, int width, bool color) {
  const auto filled = static_cast<std::size_t>(std::clamp(fraction, 0.0, 1.0) * width);
  const std::string done(filled, '#');
  const std::string rest(static_cast<std::size_t>(width) - filled, '-');
  return color ? fmt::format("[\x1b[32m{}\x1b[0m{}]", done, rest)
               : fmt::format("[{}{}]", done, rest);
}

}  // namespace

const char* stage_name(render::Stage stage) {
  switch (stage) {
    case render::Stage::world:
      return "building the world";
    case render::Stage::tree:
      return "building the tree";
    case render::Stage::kernels:
      return "compiling kernels";
    case render::Stage::upload:
      return "uploading";
    case render::Stage::rays:
      return "tracing rays";
    case render::Stage::done:
      break;
  }
  return "done";
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long long>(std::lround(std::clamp(seconds, 0.0, 1e9)));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string plain_line(const ProgressView& view) {
  return fmt::format("{}  {}{}{}", head_of(view), percent(view), rate(view), left(view));
}

std::string terminal_line(const ProgressView& view, int columns, bool color) {
  const int room = std::max(columns - 1, 0);
  const std::string head = head_of(view);
  const auto width_of = [](const std::string& text) { return static_cast<int>(text.size()); };
  const std::string tails[] = {percent(view) + rate(view) + left(view), percent(view) + left(view),
                               percent(view)};
  for (const std::string& tail : tails) {
    // A bar takes up its width, two brackets and two spaces.
    const int bar_room = room - width_of(head) - width_of(tail) - 4;
    if (bar_room >= kNarrowestBar) {
      return fmt::format("{} {} {}", head,
                         bar(view.fraction, std::min(bar_room, kWidestBar), color), tail);
    }
    const std::string line = fmt::format("{} {}", head, tail);
    if (width_of(line) <= room) return line;
  }
  return fmt::format("{} {}", head, percent(view)).substr(0, static_cast<std::size_t>(room));
}

}  // namespace aerostat::cli
