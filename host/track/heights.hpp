#pragma once

#include <optional>
#include <vector>

#include "track/flight.hpp"
#include "track/standing.hpp"

namespace aerostat::track {

/// What a choice between heights rests on.
struct HeightEvidence {
  HeightReference reference = HeightReference::unknown;
  bool has_gnss = false, has_pressure = false;  // for most fixes
  bool has_ground = false;
  EndOffsets gnss, pressure;  // over the ground, only where the logger rested
};

/// Which heights are taken, and what is added to them at both ends.
struct HeightChoice {
  HeightSource source = HeightSource::none;
  double shift_start_m = 0.0, shift_end_m = 0.0;
  std::vector<std::string> notes;  // sentences
};

/// Chooses between the heights of a file, as fit_heights promises.
HeightChoice choose_heights(const HeightEvidence& evidence);

}  // namespace aerostat::track
