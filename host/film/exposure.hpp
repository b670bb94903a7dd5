#pragma once

#include <functional>
#include <map>

#include "film/timeline.hpp"

namespace aerostat::film {

/// The two moments between whose light a time is exposed. They count in steps of /film/meter_s.
struct MeterSpan {
  int from = 0;
  double share = 0.0;  // of the way to the next moment; 0: the next one does not count
};

MeterSpan meter_span(const scene::Film& film, double time_s);

/// Returns the time of a moment.
double meter_time(const scene::Film& film, int moment);

/// The exposure of a film. The light is metered at moments that are some seconds apart, and between
/// them the stops change evenly. So the exposure of a frame follows from the scene and its number
/// alone, and it never flickers.
class Exposure {
 public:
  /// Returns the stops that suit a scene.
  using Meter = std::function<double(const scene::Scene&)>;

  Exposure(Timeline& timeline, Meter meter);

  /// Returns the stops at a time. Each moment is metered once.
  double ev_at(double time_s);

 private:
  double ev_of(int moment);

  Timeline& timeline_;
  Meter meter_;
  std::map<int, double> metered_;
};

}  // namespace aerostat::film
