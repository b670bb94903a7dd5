#include "film/exposure.hpp"

#include <cmath>
#include <utility>

#include "scene/scene.hpp"

namespace aerostat::film {

MeterSpan meter_span(const scene::Film& film, double time_s) {
  const double steps = time_s / film.meter_s, whole = std::floor(steps);
  return {static_cast<int>(whole), steps - whole};
}

double meter_time(const scene::Film& film, int moment) {
  return moment * film.meter_s;
}

Exposure::Exposure(Timeline& timeline, Meter meter)
    : timeline_(timeline), meter_(std::move(meter)) {}

double Exposure::ev_of(int moment) {
  const auto known = metered_.find(moment);
  if (known != metered_.end()) return known->second;
  const double ev = meter_(timeline_.scene_at_time(meter_time(timeline_.film(), moment)));
  metered_.emplace(moment, ev);
  return ev;
}

double Exposure::ev_at(double time_s) {
  const MeterSpan span = meter_span(timeline_.film(), time_s);
  const double from = ev_of(span.from);
  if (span.share == 0.0) return from;
  return std::lerp(from, ev_of(span.from + 1), span.share);
}

}  // namespace aerostat::film
