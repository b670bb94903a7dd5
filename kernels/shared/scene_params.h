#ifndef AEROSTAT_SHARED_SCENE_PARAMS_H
#define AEROSTAT_SHARED_SCENE_PARAMS_H

#include "air_params.h"
#include "layout.h"
#include "material.h"
#include "night_params.h"

/* Describes the scene for shading. Lengths are in metres, colours in linear Rec. 709, and slopes
 * are cosines (the y of a unit normal). */

#define AERO_MAX_POINT_LIGHTS 16
#define AERO_MAX_BALLOONS 33

#define AERO_SHADING_FLAT 0
#define AERO_SHADING_GOURAUD 1
#define AERO_SHADING_PHONG 2

typedef struct AeroPointLight {
  aero_float position[3];
  aero_float intensity[3]; /* irradiance times distance squared */
  aero_uint shadows;
} AeroPointLight;

AERO_ASSERT_LAYOUT(AeroPointLight, 28);

/* Size of the chart of clouds: a square of cells around the eye that says where there are no heaped
 * clouds. */
#define AERO_CHART_SIDE 512
#define AERO_CHART_WORDS 65536

/* The place of the chart of clouds. */
typedef struct AeroCloudChart {
  aero_float x0, z0; /* lower corner of the chart, metres */
  aero_float cell;   /* side of a cell, metres */
  aero_uint side;    /* cells along a side: AERO_CHART_SIDE, or 0 without a chart */
} AeroCloudChart;

AERO_ASSERT_LAYOUT(AeroCloudChart, 16);

/* Four cells of the chart of clouds, from the lowest byte on. Cells lie in rows along x from the
 * lowest z on. A cell's byte is 0 where there may be clouds. Elsewhere it is the number of cells
 * along x or z to the next cell with a 0. */
typedef struct AeroChartWord {
  aero_uint cells;
} AeroChartWord;

AERO_ASSERT_LAYOUT(AeroChartWord, 4);

/* Heaped clouds over flat bases. There are none if the extinction is 0. */
typedef struct AeroCumulus {
  aero_float base, thickness; /* height of the bases above the sea, and of the layer, metres */
  aero_float size;            /* width of a cloud, metres */
  aero_float threshold;       /* threshold of the noise that says where clouds are */
  aero_float extinction;
  aero_uint seed;
  aero_float drift[2]; /* how far the wind has carried the clouds along x and z, metres */
  aero_float rise;     /* how far their bulges have risen through them, metres */
  AeroCloudChart chart;
} AeroCumulus;

AERO_ASSERT_LAYOUT(AeroCumulus, 52);

/* The sun and the clouds. By night the moon is the sun of all that light does here. */
typedef struct AeroSky {
  aero_float sun_direction[3];
  aero_float sun_irradiance[3]; /* irradiance outside the air */
  aero_float sun_chord;         /* distance between unit vectors to the disc's middle and rim */
  aero_float cloud_cover;       /* cover of thin high cloud, 0 to 1 */
  aero_float cloud_height;      /* height of thin high cloud above the eye, metres */
  aero_float cloud_drift[2];    /* how far the wind has carried it along x and z, metres */
  aero_float cloud_bend;        /* how far what bends its streaks has gone ahead, metres */
  aero_uint sun_shadows;
  aero_float sun_spread;    /* tangent of the disc's radius as shadows see it, or 0 for a point */
  aero_float ambient_reach; /* metres within which occluders of the sky count, or 0 if none do */
  aero_uint bounced;        /* 1 if surfaces that hide the sky are lit by the sun */
  aero_uint moonlit;        /* 1 if the sun of all this is the moon, because the sun is down */
  /* 1 if there is no air, and the sky has one radiance in all directions. Its table and its ambient
   * light are then radiances and no multiples of sun_irradiance. */
  aero_uint is_even;
  AeroCumulus cumulus;
} AeroSky;

AERO_ASSERT_LAYOUT(AeroSky, 124);

/* Lists the numbers that the host copies from scene::Ground as they are. NUMBER is called with the
 * member of AeroGround and the member of scene::Ground. */
#define AERO_GROUND_NUMBERS(NUMBER)  \
  NUMBER(snow_line, snow_line_m)     \
  NUMBER(snow_fuzz, snow_fuzz_m)     \
  NUMBER(beach_top, beach_top_m)     \
  NUMBER(relief, relief)             \
  NUMBER(softness, softness)         \
  NUMBER(sparkle, sparkle)           \
  NUMBER(forest_top, forest_top_m)   \
  NUMBER(forest_share, forest_share) \
  NUMBER(canopy, canopy_m)           \
  NUMBER(field_width, field_m)

/* The colour rules of the ground. */
typedef struct AeroGround {
  aero_float cover_a[3], cover_b[3], rock_a[3], rock_b[3], snow[3], beach[3], forest[3], field[3];
  aero_float rock_cos[2]; /* slopes at which rock begins and is complete (begin > complete) */
  aero_float snow_cos[2]; /* snow is full above the first slope, and absent below the second */
  aero_float pattern;
  aero_float ripple;
  aero_float wind[2]; /* unit vector of the wind, x and z */
  aero_float strata;  /* thickness of the largest beds of rock, or 0 without beds */
  aero_uint seed;
  /* The ground lies lower by this number times the square of the distance from the terrain's centre
   * because the Earth is round, or 0. */
  aero_float fall;
  aero_uint has_cover; /* 1 if land cover says where what grows, as far as it reaches */
#define AERO_NUMBER(member, source) aero_float member;
  AERO_GROUND_NUMBERS(AERO_NUMBER)
#undef AERO_NUMBER
} AeroGround;

#define AERO_BYTES(member, source) +4
AERO_ASSERT_LAYOUT(AeroGround, 144 AERO_GROUND_NUMBERS(AERO_BYTES));
#undef AERO_BYTES

/* How tests follow paths. AERO_PATHS_WITHOUT_LIGHT_RAYS traces no rays to the sun's disc and to the
 * sky, and AERO_PATHS_PLAIN also goes on in all directions alike. The mean over samples is the
 * same.
 */
#define AERO_PATHS_WITHOUT_LIGHT_RAYS 1
#define AERO_PATHS_PLAIN 2
#define AERO_PATHS_SEEK_THE_SKY 3 /* traces rays to the sky even if it is evenly bright */

typedef struct AeroWater {
  aero_float absorption[3]; /* absorption per metre */
  aero_float scatter[3], bed[3];
  aero_float level, wave, wave_slope;
  aero_float time; /* time at which the waves are seen, seconds */
} AeroWater;

AERO_ASSERT_LAYOUT(AeroWater, 52);

/* Light in and around a balloon. Light that is scattered about inside the envelope lights its
 * inner side evenly. glow_sun and glow_sky are shares of the sun's irradiance and of the sky's mean
 * one, and glow_flame is what the burners give, as irradiance / pi. The direct light of the burners
 * comes from a point. */
typedef struct AeroBalloon {
  aero_float glow_sun[3], glow_sky[3], glow_flame[3];
  aero_float flame[3];       /* position of the burners */
  aero_float flame_light[3]; /* irradiance / pi at a distance of 1 m */
  aero_uint artwork;         /* place of its pictures (artwork.h) in the buffer of texels, or 0 */
} AeroBalloon;

AERO_ASSERT_LAYOUT(AeroBalloon, 64);

/* A picture over the ground, in levels of detail: squares around one point with the same number of
 * texels. Each is twice as wide as the one before. The texels lie in the buffer of texels, level by
 * level and row by row from the least z on. A texel is a word whose lowest byte is red, and green,
 * blue and opacity follow. A byte of colour is 255 times the square root of the albedo multiplied
 * by the opacity. */
typedef struct AeroDrape {
  aero_float middle[2]; /* x and z of the middle of all levels, over the terrain, metres */
  aero_float texel;     /* width of a texel of the first level, metres */
  aero_uint side;       /* texels along a side of a level */
  aero_uint levels;     /* 0 without a picture */
  aero_float blend;     /* share of the picture in the colour of the ground, 0 to 1 */
  aero_uint first;      /* place of the first texel in the buffer of texels */
} AeroDrape;

AERO_ASSERT_LAYOUT(AeroDrape, 28);

/* The classes of ground that land cover tells apart, in the order of CoverClass of the host. */
#define AERO_COVER_WOODS 0
#define AERO_COVER_SHRUB 1
#define AERO_COVER_MEADOW 2
#define AERO_COVER_CROPS 3
#define AERO_COVER_BARE 4
#define AERO_COVER_SNOW 5
#define AERO_COVER_BUILT_UP 6
#define AERO_COVER_WETLAND 7
#define AERO_COVER_CLASSES 8

/* Land cover. The levels of its map are those of a picture. A texel has four bits for the share of
 * each class in 15ths, that of the first class the lowest ones. */
typedef struct AeroCover {
  AeroDrape map;                            /* its blend is not used */
  aero_float colors[AERO_COVER_CLASSES][3]; /* albedos of the classes below trees and snow */
} AeroCover;

AERO_ASSERT_LAYOUT(AeroCover, 28 + 96);

/* The numbers of a scene. The table of the sky (AeroSkyCell) and the chart of clouds
 * (AeroChartWord) are buffers of their own. So are the texels of all pictures: one buffer of words,
 * in which each picture says where its first word is. */
typedef struct AeroScene {
  AeroSky sky;
  AeroGround ground;
  AeroWater water;
  AeroBalloon balloons[AERO_MAX_BALLOONS];
  AeroMaterial materials[AERO_MAX_MATERIALS];
  AeroPointLight lights[AERO_MAX_POINT_LIGHTS];
  aero_uint light_count;
  aero_uint balloon_count;
  aero_uint shading;     /* one of AERO_SHADING_... */
  aero_uint bounces;     /* how often a path goes on from a surface to another one */
  aero_uint plain_paths; /* 0, or one of AERO_PATHS_... */
  AeroAir air;
  /* The place of the origin of positions, as seen from the terrain's centre at sea level. Positions
   * count from a point near the eye, while patterns and heights go by places. */
  aero_float place[3];
  AeroNight night;
  AeroDrape drape;
  aero_uint white_texture; /* place of the texture of materials that have none */
  aero_uint any_artwork;   /* AeroBalloon::artwork of a balloon that has pictures, or 0 */
  AeroCover cover;
} AeroScene;

AERO_ASSERT_LAYOUT(AeroScene, (1128 + AERO_MAX_BALLOONS * sizeof(AeroBalloon)) +
                                  sizeof(AeroGround) + sizeof(AeroNight) + sizeof(AeroDrape) +
                                  sizeof(AeroCover) + AERO_MAX_MATERIALS * sizeof(AeroMaterial));

#endif
