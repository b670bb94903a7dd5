#pragma once

#include <optional>

#include "core/math.hpp"
#include "land/land.hpp"
#include "land/nested_levels.hpp"

namespace aerostat::land {

/// The light in a picture of land from above: that of the sun at the moment it was taken, and that
/// of the sky.
struct PictureLight {
  double azimuth_deg = 0.0, elevation_deg = 0.0;  // of the sun
  vec3 sky{0.0f};            // what full shade gets, relative to level ground, by colour
  double correlation = 0.0;  // of the logarithms of the picture's luminance and of this light
};

/// Finds the light in a picture, whose texels are those of a drape: the sun whose light and shade
/// on the land go best with the picture's. Returns nothing if no sun's do, because the picture has
/// none, shows clouds, or was taken at noon over flat land. `cell_m` is the distance of the samples
/// of the land's heights in metres.
std::optional<PictureLight> find_light(const NestedLevels& picture, const LocalLand& land,
                                       double cell_m);

/// Divides the texels of a picture by its light, so that the same ground has the same colour in
/// light and in shade. `strength` is 0 (nothing happens) to 1.
void lift_light(NestedLevels& picture, const LocalLand& land, double cell_m,
                const PictureLight& light, double strength);

/// Returns the correlation of the logarithms of a picture's luminance and of a light.
double light_left(const NestedLevels& picture, const LocalLand& land, double cell_m,
                  const PictureLight& light);

}  // namespace aerostat::land
