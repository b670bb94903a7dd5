#ifndef AEROSTAT_SHARED_CAMERA_H
#define AEROSTAT_SHARED_CAMERA_H

#include "layout.h"

#define AERO_LENS_PINHOLE 0
#define AERO_LENS_THIN 1
#define AERO_LENS_PANORAMA 2
#define AERO_LENS_ORTHOGRAPHIC 3

/* A camera; its position counts from where those of meshes do. Image point (x, y), in pixels from
 * the top left corner, is the vector p = corner + x step_x + y step_y from `origin`. A pinhole's
 * ray goes from there through p, one unit of depth ahead; a thin lens's from a point of its disc
 * across the axis through focus p. An orthographic ray goes from p ahead; where there is nothing
 * for `lead` metres before the eye, `origin` lies that much ahead of it. A panorama has no use for
 * p. */
typedef struct AeroCamera {
  aero_float origin[3];
  aero_float corner[3];
  aero_float step_x[3];
  aero_float step_y[3];
  aero_float right[3], up[3], forward[3]; /* unit */
  aero_float aperture;                    /* of a thin lens: its radius, metres */
  aero_float focus;                       /* of a thin lens: depth of the sharp plane, metres */
  aero_float lead;                        /* of parallel rays */
  aero_uint lens;                         /* AERO_LENS_... */
} AeroCamera;

AERO_ASSERT_LAYOUT(AeroCamera, 100);

#define AERO_FILTER_BOX 0
#define AERO_FILTER_TENT 1
#define AERO_FILTER_GAUSSIAN 2

/* What changes from frame to frame but not within it. */
typedef struct AeroFrame {
  AeroCamera camera;
  aero_uint width, height; /* of the image, pixels */
  aero_uint filter;        /* AERO_FILTER_... */
  aero_uint samples;       /* per pixel in all; 1 takes the pixel's centre */
  aero_uint sample_stride; /* coprime to samples: the order in which strata are taken */
  aero_uint sample_shift;  /* of the pattern, from the seed; 2^32 is once around */
  aero_uint progressive;   /* 1: the first samples of a pixel must do without the rest */
  aero_float pixel_angle;  /* radians across one pixel in the middle of the image */
  aero_float pixel_width;  /* metres across one pixel beside what its angle makes of the distance */
  aero_float filter_scale; /* of the filter: 1, or less where one pixel is taken of several */
} AeroFrame;

AERO_ASSERT_LAYOUT(AeroFrame, 140);

/* The work of one launch: blocks of pixels, one packet of lanes each. A packet holds 2^log2_w x
 * 2^log2_h pixels with 2^log2_samples samples each; their product is LANES. */
typedef struct AeroTile {
  aero_uint x0, y0; /* first pixel */
  aero_uint x1, y1; /* end of the pixels to be written */
  aero_uint blocks_per_row;
  aero_uint block_count;
  aero_uint first_sample;
  aero_uint log2_w, log2_h, log2_samples;
} AeroTile;

AERO_ASSERT_LAYOUT(AeroTile, 40);

/* The part of the image that a film holds, row by row. */
typedef struct AeroWindow {
  aero_uint x0, y0; /* first pixel */
  aero_uint width, height;
} AeroWindow;

AERO_ASSERT_LAYOUT(AeroWindow, 16);

/* What every rendering kernel is launched with. The tile lies inside the film's window. */
typedef struct AeroLaunch {
  AeroFrame frame;
  AeroTile tile;
  AeroWindow film;
} AeroLaunch;

AERO_ASSERT_LAYOUT(AeroLaunch, 196);

#endif
