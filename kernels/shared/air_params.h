#ifndef AEROSTAT_SHARED_AIR_PARAMS_H
#define AEROSTAT_SHARED_AIR_PARAMS_H

#include "layout.h"

/* The sunlit air over a landscape. Light is per irradiance of the sun outside the air, heights and
 * lengths in metres above the sea, coefficients per metre, colours linear Rec. 709. */

/* The eye's sky: columns by u = sin(azimuth from the sun / 2), 0 to 1; rows by the height s = y +
 * horizon_sine over the horizon, above s = v^2 (1 + horizon_sine), below s = -v^2 (1 -
 * horizon_sine). */
#define AERO_SKY_COLUMNS 24
#define AERO_SKY_ROWS_ABOVE 40
#define AERO_SKY_ROWS_BELOW 16
#define AERO_SKY_CELLS 1344

/* Radiance = add + haze * (the haze's phase). */
typedef struct AeroSkyCell {
  aero_float add[3], haze[3];
} AeroSkyCell;

AERO_ASSERT_LAYOUT(AeroSkyCell, 24);

/* Fills valleys up to `top`, thins out above it over `softness`. */
typedef struct AeroFog {
  aero_float extinction; /* deep inside, 0 = no fog */
  aero_float top, softness;
  aero_float billow, billow_width;
  aero_float sun_way; /* way towards the sun per height */
} AeroFog;

AERO_ASSERT_LAYOUT(AeroFog, 24);

typedef struct AeroAir {
  aero_float molecules[3];                           /* scattering at the sea */
  aero_float haze_scattering[3], haze_extinction[3]; /* at the sea */
  aero_float molecules_height, haze_height;          /* over which they fall to 1/e */
  aero_float haze_asymmetry;
  aero_float depth_molecules[3], depth_haze[3]; /* towards the sun from the sea */
  aero_float depth_ozone[3];
  aero_float scattered_depth_haze[3]; /* depth_haze for light that the air scatters */
  aero_float sun_heights[2]; /* none of the disc is seen below the first, all above the second */
  /* Light of later orders, even[0] + even[1] x + even[2] x^2, and what haze sends up beyond that
   * per cosine. x is the height or, where thick_haze is not 0, 1 - the haze's density. */
  aero_float around[3][3], around_slant[3][3];
  aero_float around_least[3]; /* of the even part */
  aero_float around_top;      /* the greatest x */
  aero_float thick_haze;
  aero_float ambient[9][3]; /* irradiance / pi by the normal, in spherical harmonics */
  aero_float horizon_sine;
  AeroFog fog;
  AeroSkyCell sky[AERO_SKY_CELLS];
} AeroAir;

AERO_ASSERT_LAYOUT(AeroAir, 32588);

#endif
