#ifndef AEROSTAT_SHARED_NIGHT_PARAMS_H
#define AEROSTAT_SHARED_NIGHT_PARAMS_H

#include "air_params.h"

/* Describes moon and stars. Angles are in radians, directions are unit vectors. */

/* The moon's disc. There is none if the radius is 0. */
typedef struct AeroMoon {
  aero_float direction[3];
  aero_float right[3], up[3]; /* axes of the disc as seen from the ground; up is its north */
  aero_float to_sun[3];       /* from the moon to the sun */
  aero_float radiance[3];     /* mean of a full disc, outside the air */
  aero_float radius, soft;    /* of the disc, and of its smoothed rim */
  aero_float earthlight;      /* light of the Earth on it as a share of the sun's */
} AeroMoon;

AERO_ASSERT_LAYOUT(AeroMoon, 72);

/* A cube around the eye has AERO_STAR_SIDE x AERO_STAR_SIDE cells on each side. A cell knows the
 * stars whose blur reaches into it. */
#define AERO_STAR_SIDE 32
#define AERO_STAR_CELLS 6144

/* A star and its light. Stars stand behind the cells of the sky in the same buffer. */
typedef struct AeroStar {
  aero_float direction[3]; /* in the frame of the equator of 2000 */
  aero_float radiance[3];  /* in the middle of its blur, outside the air */
} AeroStar;

AERO_ASSERT_LAYOUT(AeroStar, 24);

/* The number of the first star of a cell. The stars of a cell end where those of the next begin.
 * These numbers, one more than there are cells, stand behind the stars. */
typedef struct AeroStarStart {
  aero_uint star;
} AeroStarStart;

AERO_ASSERT_LAYOUT(AeroStarStart, 4);

/* The starry sky. There are no stars if `first` is 0. */
typedef struct AeroStars {
  aero_float equator[9];   /* rows of the matrix from the scene's frame to that of the equator */
  aero_float galaxy[9];    /* rows of the matrix from the scene's frame to that of the galaxy */
  aero_float reach;        /* radius of a star's blur */
  aero_float sharpness;    /* a star's light falls as exp(-sharpness * distance^2) */
  aero_float milky_way;    /* radiance of its brightest part outside the air, grey */
  aero_float pixel;        /* radians of a pixel */
  aero_uint first, starts; /* places of the stars and of their starts in the buffer of the sky */
} AeroStars;

AERO_ASSERT_LAYOUT(AeroStars, 96);

typedef struct AeroNight {
  AeroMoon moon;
  AeroStars stars;
  aero_float depth[3]; /* optical depth of the air above the eye */
  aero_uint glowing;   /* 1 if the afterglow of the sun has a table of its own, behind the first */
  aero_float glow_direction[3];  /* towards the sun */
  aero_float glow_irradiance[3]; /* of the sun outside the air */
} AeroNight;

AERO_ASSERT_LAYOUT(AeroNight, 208);

#endif
