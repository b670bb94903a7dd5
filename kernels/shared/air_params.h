#ifndef AEROSTAT_SHARED_AIR_PARAMS_H
#define AEROSTAT_SHARED_AIR_PARAMS_H

#include "layout.h"

/* Describes the sunlit air over a landscape. Light is given per irradiance of the sun outside the
 * air. Heights are in metres above the sea, lengths in metres, coefficients per metre, and colours
 * in linear Rec. 709. */

/* The sky as the eye sees it is a table. Its columns go by u = sin(azimuth from the sun / 2), from
 * 0 to 1. Its rows go by v, from 0 to 1, and s = y + horizon_sine, where y is the direction's
 * upward component:
 *   s = v^2 (1 + horizon_sine)     above the horizon
 *   s = -v^2 (1 - horizon_sine)    below the horizon */
#define AERO_SKY_COLUMNS 24
#define AERO_SKY_ROWS_ABOVE 40
#define AERO_SKY_ROWS_BELOW 16
#define AERO_SKY_CELLS 1344

/* A cell of the sky's table. Its radiance is add + haze * (the haze's phase function). */
typedef struct AeroSkyCell {
  aero_float add[3], haze[3];
} AeroSkyCell;

AERO_ASSERT_LAYOUT(AeroSkyCell, 24);

/* The probabilities by which paths choose directions of the sky (importance sampling). A strip lies
 * between two rows of the table. Strips go from the horizon up, then from the horizon down, as the
 * rows do. Within a cell between two rows and two columns all directions are equally likely. */
#define AERO_SKY_STRIPS 54
#define AERO_SKY_STRIPS_ABOVE 39
#define AERO_SKY_STRIP_SLOTS 64  /* a power of two above AERO_SKY_STRIPS */
#define AERO_SKY_COLUMN_SLOTS 32 /* a power of two above AERO_SKY_COLUMNS */

typedef struct AeroSkyImportance {
  /* Cumulative probabilities: of all strips before one, and of all cells of a strip before one.
   * Slots behind the last one hold 1. */
  aero_float strips[AERO_SKY_STRIP_SLOTS];
  aero_float cells[AERO_SKY_STRIPS][AERO_SKY_COLUMN_SLOTS];
  aero_float ends[AERO_SKY_STRIPS][2];  /* upward components of the two ends of a strip */
  aero_float turns[AERO_SKY_COLUMNS];   /* azimuths of the columns from the sun, in turns */
  aero_float densities[AERO_SKY_CELLS]; /* per steradian, by the first corner of a cell */
  aero_uint
      sought; /* 1 if the sky is so uneven that rays to its bright parts are worth their time */
} AeroSkyImportance;

AERO_ASSERT_LAYOUT(AeroSkyImportance, 4 * (64 + 54 * 32 + 108 + 24 + 1344 + 1));

/* Fog that fills valleys up to `top` and thins out above it over `softness`. */
typedef struct AeroFog {
  aero_float extinction; /* extinction deep inside the fog, or 0 without fog */
  aero_float top, softness;
  aero_float billow, billow_width;
  aero_float sun_way; /* metres towards the sun for each metre of height */
} AeroFog;

AERO_ASSERT_LAYOUT(AeroFog, 24);

/* Nodes along a side of a map of shadows. */
#define AERO_SHADOW_SIDE 512

/* A square map over the plane: AERO_SHADOW_SIDE rows of as many words in the buffer of texels.
 * Columns go by u, the metres towards the sun, and rows by v, the metres across. A word holds
 * values of its node and of the next ones, from the lowest bits on:
 *   land     16 bits of the node and of that in the next row; their unit is `unit` metres, from
 *            `low` metres above the sea on
 *   clouds   8 bits of the node, the next in its row, and the two of the next row; 255 is 1 */
typedef struct AeroShadowMap {
  aero_float u, v, cell; /* place of the first node, and metres between nodes */
  aero_float low, unit;
  aero_uint first; /* place of the first node in the buffer of texels */
} AeroShadowMap;

AERO_ASSERT_LAYOUT(AeroShadowMap, 24);

/* The shadows of land and heaped clouds in the air. A point over the terrain has
 *   u = sun[0] x + sun[1] z    v = sun[0] z - sun[1] x */
typedef struct AeroAirShadows {
  aero_float sun[2];                /* unit vector towards the sun over the plane, x and z */
  aero_uint by_land, by_clouds;     /* 1 if there is a map */
  aero_uint points;                 /* points of a step through the air that are looked at */
  AeroShadowMap land;               /* heights below which land hides the sun */
  aero_float land_softness;         /* metres of height over which its shadows begin */
  AeroShadowMap clouds;             /* shares of sunlight that are left at the bases of clouds */
  aero_float cloud_base, cloud_top; /* heights between which all shadows of clouds begin */
  aero_float cloud_slant; /* metres over the plane towards the sun for each metre upwards */
  aero_float cloud_mean;  /* mean of the map, which counts beyond its rim */
  aero_float top;         /* height above which nothing is in shadow */
} AeroAirShadows;

AERO_ASSERT_LAYOUT(AeroAirShadows, 92);

typedef struct AeroAir {
  aero_float molecules[3];                           /* scattering at sea level */
  aero_float haze_scattering[3], haze_extinction[3]; /* coefficients at sea level */
  aero_float molecules_height, haze_height; /* heights over which the densities fall to 1/e */
  aero_float haze_asymmetry;
  aero_float depth_molecules[3], depth_haze[3]; /* optical depths from sea level to the sun */
  aero_float depth_ozone[3];
  aero_float scattered_depth_haze[3]; /* depth_haze for light that the air scatters */
  /* None of the sun's disc is seen from below the first height, and all of it from above the
   * second. */
  aero_float sun_heights[2];
  /* Light of later orders: around[0] + around[1] x + around[2] x^2 in all directions alike, and
   * around_slant, in the same form, is what haze sends up beyond that per cosine. x is the height,
   * or 1 minus the haze's density if thick_haze is not 0. */
  aero_float around[3][3], around_slant[3][3];
  aero_float around_least[3]; /* the least value of `around` */
  aero_float around_top;      /* greatest x of `around` */
  aero_float thick_haze;
  aero_float ambient[9][3]; /* irradiance / pi by the normal, in spherical harmonics */
  /* Irradiance / pi of a plane that faces up above heaped clouds, and of one that faces down. */
  aero_float above_clouds[3], below_clouds[3];
  /* A deck of clouds has its bases at the height deck_base. The air below gets the share deck_sun
   * of the sunlight and the share deck_around of all other light. */
  aero_float deck_base, deck_sun, deck_around;
  aero_float deck_level; /* light that diffuses in clouds, relative to that of separate heaps */
  aero_float horizon_sine;
  AeroFog fog;
  AeroAirShadows shadows;
} AeroAir;

AERO_ASSERT_LAYOUT(AeroAir, 464);

#endif
