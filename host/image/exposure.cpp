#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <tbb/parallel_for.h>

#include "image/tone.hpp"
#include "image/write.hpp"

namespace aerostat::image {

namespace {

// Where the middle of a picture goes: between the classical 0.18 and what daylight looks like.
constexpr double kGrey = 0.25;
// The shares of the pixels that the middle lies between: a dark foreground, or the sun and what
// mirrors it, says little of the view.
constexpr double kDarkShare = 0.2, kBrightShare = 0.95;
// Where the brightest hundredth may go: the tone curve still tells it from white.
constexpr double kLightsShare = 0.99, kLights = 2.0;
// But the whole is darkened for its sake by so many stops at most: a glitter on the sea may clip.
constexpr double kMostHeldBack = 2.0;
// Where the lights leave room, the whole goes this share of it up, for whites that are white, but
// of so many stops at most: a dull view has none.
constexpr double kRaisedShare = 0.3, kMostRoom = 1.5;

/// The logarithms, to the base of 2, of all luminance there is.
std::vector<double> stops_of(const Film& film) {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  std::vector<double> stops(film.radiance.size());
  tbb::parallel_for(std::size_t{0}, stops.size(), [&](std::size_t i) {
    const double light = luminance(dvec3(film.radiance[i]));
    stops[i] = light > 1e-9 && std::isfinite(light) ? std::log2(light) : kNone;
  });
  std::erase(stops, kNone);
  return stops;
}

}  // namespace

double automatic_exposure_ev(const Film& film) {
  std::vector<double> stops = stops_of(film);
  if (stops.empty()) return 0.0;
  const auto at = [&stops](double share) {
    const auto last = static_cast<double>(stops.size() - 1);
    return stops.begin() + static_cast<std::ptrdiff_t>(share * last);
  };
  const auto from = at(kDarkShare), to = at(kBrightShare), lights = at(kLightsShare);
  std::nth_element(stops.begin(), from, stops.end());
  std::nth_element(from, to, stops.end());
  std::nth_element(to, lights, stops.end());
  const double middle =
      from == to ? *from : std::accumulate(from, to, 0.0) / static_cast<double>(to - from);
  const double wanted = std::log2(kGrey) - middle;
  const double room = std::log2(kLights) - *lights - wanted;
  if (room > 0.0) return wanted + kRaisedShare * std::min(room, kMostRoom);
  return wanted + std::max(room, -kMostHeldBack);
}

}  // namespace aerostat::image
