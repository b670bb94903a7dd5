#pragma once

#include <memory>

#include "core/math.hpp"
#include "scene_params.h"

namespace aerostat::pack {

/// Where around the place of the eye (x and z count) the clouds have no density at any height or
/// footprint, as the device's cumulus.clh defines it: what is marked as clear surely is. Bounds of
/// noise by its value and slope in the middle of squares, which are halved where that does not
/// tell. Null if there are no clouds or nearly only clouds. Of `clouds` all but the chart counts.
/// Cells lie the same whatever the eye; the last chart is kept. May be called from any thread.
std::shared_ptr<const AeroCloudChart> cloud_chart(const AeroCumulus& clouds, const vec3& eye);

}  // namespace aerostat::pack
