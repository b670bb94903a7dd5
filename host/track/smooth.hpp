#pragma once

#include <vector>

namespace aerostat::track {

/// Returns the values smoothed over a window of time. Each is replaced by what a straight line
/// through its neighbours says, and nearer neighbours count more. Steady climbs stay as they are,
/// at the ends as well. `times` rise strictly. A window of 0 returns the values.
std::vector<double> smoothed(const std::vector<double>& times, const std::vector<double>& values,
                             double window);

/// Returns the value at a time of the curve through all points. The curve is smooth and does not
/// rise or fall beyond the points on both sides (a monotone cubic of Fritsch and Butland). `times`
/// rise strictly, and there is at least one. Before and behind the points the curve is flat.
double value_at(const std::vector<double>& times, const std::vector<double>& values, double time);

}  // namespace aerostat::track
