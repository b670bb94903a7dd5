#ifndef AEROSTAT_RULES_DAYLIGHT_H
#define AEROSTAT_RULES_DAYLIGHT_H

#include "air_params.h"
#include "rules/steps.h"

/* Sunlight on its way down through clear air. Heights are in metres above the sea. */

AERO_RULES_BEGIN

/* Asymmetry of the fog's phase function, and the share of its light that it scatters directly.
 * Chosen by eye. */
#define FOG_ASYMMETRY 0.8f
#define FOG_DIRECT 0.25f

/* Returns a height in scale heights, limited to -60 to 60 so that a float can hold its
 * exponential. */
AERO_REAL_RULE lane_real scaled_height(lane_real height, float scale) {
  return lane_max(lane_min(height / scale, (lane_real)60.0f), (lane_real)-60.0f);
}

/* Returns the density of a part of the air at a height as a share of that at the sea, by the height
 * over which it falls to 1/e. */
AERO_REAL_RULE lane_real density_share(lane_real height, float scale) {
  return exp(-scaled_height(height, scale));
}

/* Returns the share of the sun's disc that stands above the planet's horizon at a height. */
AERO_REAL_RULE lane_real sun_share(AERO_GLOBAL const AeroAir* air, lane_real height) {
  return smooth_step((lane_real)air->sun_heights[0], (lane_real)air->sun_heights[1], height);
}

/* Returns the transmittance for one of the three colours from a point to the sun. `molecules` and
 * `haze` are the densities at the point as shares of those at the sea, and `depth_haze` is the
 * optical depth of all haze, one of those of `air`. */
AERO_REAL_RULE lane_real sun_transmittance(AERO_GLOBAL const AeroAir* air,
                                           AERO_GLOBAL const aero_float* depth_haze,
                                           lane_real molecules, lane_real haze, int color) {
  const lane_real clear = lane_fma((lane_real)air->depth_molecules[color], molecules,
                                   (lane_real)air->depth_ozone[color]);
  return exp(-lane_fma((lane_real)depth_haze[color], haze, clear));
}

AERO_RULES_END

#endif
