#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/last_made.hpp"
#include "core/math.hpp"
#include "scene_params.h"

namespace aerostat::pack {

/// What a chart is made of: the clouds, and its lower corner, which follows the eye in steps.
struct CloudChartKey {
  float size, threshold;
  std::uint32_t seed;
  float x0, z0;

  bool operator==(const CloudChartKey&) const = default;
};

/// A chart of clouds: its place, and AERO_CHART_WORDS words of cells.
struct CloudChart {
  AeroCloudChart place{};
  std::vector<AeroChartWord> words;
};

using CloudChartCache = LastMade<CloudChartKey, CloudChart>;

/// Returns where around the place of the eye (x and z count) the clouds have no density at any
/// height or footprint, as atmosphere/cumulus.clh on the device defines it: what is marked as clear
/// surely is. It bounds the noise by its value and slope in the middle of squares, and halves
/// squares where that does not decide. It returns null if there are no clouds or nearly only
/// clouds. All of `clouds` but its chart counts. Cells lie the same whatever the eye.
std::shared_ptr<const CloudChart> cloud_chart(const AeroCumulus& clouds, const vec3& eye,
                                              CloudChartCache& cache);

}  // namespace aerostat::pack
