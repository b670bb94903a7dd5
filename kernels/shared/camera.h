#ifndef AEROSTAT_SHARED_CAMERA_H
#define AEROSTAT_SHARED_CAMERA_H

#include "layout.h"

#define AERO_LENS_PINHOLE 0
#define AERO_LENS_THIN 1
#define AERO_LENS_PANORAMA 2
#define AERO_LENS_ORTHOGRAPHIC 3

/* A camera. Its position counts from the same origin as those of meshes. The image point (x, y), in
 * pixels from the top left corner, is the vector
 *   p = corner + x step_x + y step_y
 * from `origin`. A pinhole's ray goes from `origin` through p, which is one unit of depth ahead. A
 * thin lens's ray goes from a point of its disc, which is centred at `origin`, through focus * p.
 * An orthographic ray begins at p and goes along `forward`. If nothing lies within `lead` metres
 * before the eye, `origin` lies that much ahead of the eye. A panorama does not use p. */
typedef struct AeroCamera {
  aero_float origin[3];
  aero_float corner[3];
  aero_float step_x[3];
  aero_float step_y[3];
  aero_float right[3], up[3], forward[3]; /* unit vectors */
  aero_float aperture;                    /* radius of a thin lens, metres */
  aero_float focus;                       /* depth of a thin lens's sharp plane, metres */
  aero_float lead;                        /* metres from the eye to the start of parallel rays */
  aero_uint lens;                         /* one of AERO_LENS_... */
} AeroCamera;

AERO_ASSERT_LAYOUT(AeroCamera, 100);

/* Parameters that change from frame to frame but not within a frame. */
typedef struct AeroFrame {
  AeroCamera camera;
  aero_uint width, height;  /* size of the image, pixels */
  aero_uint samples;        /* samples of a pixel in all; 1 takes its centre */
  aero_uint sample_stride;  /* stride in the order of strata, coprime to `samples` */
  aero_uint sample_shift;   /* shift of the pattern by the seed; 2^32 is a full turn */
  aero_uint progressive;    /* 1 if a pixel may stop after its first samples */
  aero_float pixel_angle;   /* radians across one pixel in the middle of the image */
  aero_float pixel_width;   /* metres across one pixel, added to its angle times distance */
  aero_float sample_spread; /* width of the square in which samples lie: 1 pixel, or less if a pixel
                             * is made of several */
  /* The mean offset of the samples of a pixel, which is taken off each of them, pixels. It is part
   * of the pattern, so that the mean place of a few samples is the centre of the pixel. */
  aero_float sample_mean[2];
} AeroFrame;

AERO_ASSERT_LAYOUT(AeroFrame, 144);

/* The work of one launch: blocks of pixels, each of which is one packet of lanes. A packet holds
 * 2^log2_w x 2^log2_h pixels with 2^log2_samples samples each, and the product of these numbers is
 * LANES. */
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

/* Arguments with which every rendering kernel is launched. The tile lies inside the film's
 * window. */
typedef struct AeroLaunch {
  AeroFrame frame;
  AeroTile tile;
  AeroWindow film;
} AeroLaunch;

AERO_ASSERT_LAYOUT(AeroLaunch, 200);

#endif
