#include "track/heights.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace aerostat::track {

namespace {

/// A logger in a basket or in a pocket is so high over the ground.
constexpr double kLoggerHeight_m = 1.0;
/// GNSS heights and elevation models together are good for this.
constexpr double kGood_m = 40.0;
/// The geoid lies between 106 m below the ellipsoid and 85 m above it.
constexpr double kLeastGeoid_m = 20.0, kMostGeoid_m = 110.0;
constexpr double kSame_m = 15.0;  // both ends are off by the same within this

HeightChoice as_is(HeightSource source) {
  return {source, 0.0, 0.0, {}};
}

/// Shifts heights so that they meet the ground at the ends that are known.
HeightChoice fitted(HeightSource source, const EndOffsets& offsets) {
  const double start_m = offsets.start_m.value_or(offsets.end_m.value_or(kLoggerHeight_m));
  const double end_m = offsets.end_m.value_or(start_m);
  HeightChoice choice{source, kLoggerHeight_m - start_m, kLoggerHeight_m - end_m, {}};
  if (!offsets.start_m || !offsets.end_m) {
    choice.notes.push_back(fmt::format("The shift is known only at the {} of the flight.",
                                       offsets.start_m ? "start" : "end"));
  }
  return choice;
}

bool any(const EndOffsets& offsets) {
  return offsets.start_m || offsets.end_m;
}

bool all_within(const EndOffsets& offsets, double least_m, double most_m) {
  const auto is_within = [&](const std::optional<double>& offset) {
    return !offset || (std::abs(*offset) >= least_m && std::abs(*offset) <= most_m);
  };
  return is_within(offsets.start_m) && is_within(offsets.end_m);
}

/// Returns by how much both ends are off, if it is the same.
std::optional<double> common_offset(const EndOffsets& offsets) {
  if (!offsets.start_m || !offsets.end_m) return std::nullopt;
  if (std::abs(*offsets.start_m - *offsets.end_m) > kSame_m) return std::nullopt;
  return 0.5 * (*offsets.start_m + *offsets.end_m);
}

HeightChoice shifted(double offset_m) {
  const double shift_m = kLoggerHeight_m - offset_m;
  return {HeightSource::gnss_shifted, shift_m, shift_m, {}};
}

/// Returns GNSS heights if the ground does not speak against them.
std::optional<HeightChoice> gnss_choice(const HeightEvidence& evidence) {
  const EndOffsets& offsets = evidence.gnss;
  const bool is_ellipsoid = evidence.reference == HeightReference::ellipsoid;
  if (!any(offsets)) {
    HeightChoice choice = as_is(HeightSource::gnss);
    if (is_ellipsoid) {
      choice.notes.emplace_back(
          "The file gives heights over the ellipsoid, which can be off by up to 106 m from those "
          "over the sea.");
    }
    return choice;
  }
  const auto common = common_offset(offsets);
  const double least_m = is_ellipsoid ? 0.0 : kLeastGeoid_m;
  if (common && all_within(offsets, least_m, kMostGeoid_m)) return shifted(*common);
  const bool has_one = !offsets.start_m || !offsets.end_m;
  if (is_ellipsoid && has_one && all_within(offsets, 0.0, kMostGeoid_m)) {
    return shifted(offsets.start_m.value_or(offsets.end_m.value_or(0.0)));
  }
  if (all_within(offsets, 0.0, kGood_m)) return as_is(HeightSource::gnss);
  return std::nullopt;
}

}  // namespace

HeightChoice choose_heights(const HeightEvidence& evidence) {
  if (evidence.has_gnss && evidence.reference == HeightReference::ground) {
    return as_is(evidence.has_ground ? HeightSource::over_ground : HeightSource::none);
  }
  if (evidence.has_gnss) {
    if (const auto choice = gnss_choice(evidence)) return *choice;
    if (evidence.has_pressure && any(evidence.pressure)) {
      HeightChoice choice = fitted(HeightSource::pressure_fitted, evidence.pressure);
      choice.notes.emplace_back(
          "The GNSS heights do not fit the ground, so the pressure heights were taken.");
      return choice;
    }
    return fitted(HeightSource::gnss_fitted, evidence.gnss);
  }
  if (evidence.has_pressure) {
    if (any(evidence.pressure)) return fitted(HeightSource::pressure_fitted, evidence.pressure);
    HeightChoice choice = as_is(HeightSource::pressure);
    choice.notes.emplace_back(
        "Pressure heights follow the weather and can be off by 200 m. They could not be tested by "
        "the ground.");
    return choice;
  }
  return as_is(evidence.has_ground ? HeightSource::assumed : HeightSource::none);
}

}  // namespace aerostat::track
