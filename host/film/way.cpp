#include "film/way.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/math.hpp"
#include "film/wind.hpp"
#include "scene/scene.hpp"

namespace aerostat::film {
namespace {

constexpr int kRows = 10;

/// Returns the azimuth that a velocity of the air comes from, 0 to below 360.
double azimuth_from(const dvec2& velocity) {
  const double azimuth = glm::degrees(std::atan2(-velocity.x, velocity.y));
  return std::fmod(azimuth + 360.0, 360.0);
}

}  // namespace

std::string way_text(Timeline& timeline) {
  const scene::Film& film = timeline.film();
  std::string text = fmt::format("film: {} frames, {:g} s at {:g} frames/s\n", timeline.frames(),
                                 film.duration_s, film.fps);
  text += fmt::format("{:>8} {:>9} {:>9} {:>9} {:>12} {:>9} {:>9}\n", "time s", "east m", "south m",
                      "height m", "above ground", "wind m/s", "from deg");
  const int steps = std::min(kRows, timeline.frames());
  for (int i = 0; i <= steps; ++i) {
    const double time = film.duration_s * i / steps;
    const dvec3 at = timeline.scene_at_time(time).balloon.position;
    const dvec2 wind = wind_at(film.wind, at.y);
    text += fmt::format("{:8.1f} {:9.1f} {:9.1f} {:9.1f} {:12.1f} {:9.1f} {:9.0f}\n", time, at.x,
                        at.z, at.y, at.y - timeline.ground_at(at.x, at.z), glm::length(wind),
                        azimuth_from(wind));
  }
  return text;
}

}  // namespace aerostat::film
