#ifndef AEROSTAT_SHARED_CAMERA_H
#define AEROSTAT_SHARED_CAMERA_H

#include "layout.h"

/* A pinhole camera: the ray of image point (x, y), in pixels from the top left corner, goes from
 * `origin` towards corner + x step_x + y step_y (world space, one unit of depth ahead). */
typedef struct AeroCamera {
  aero_float origin[3];
  aero_float corner[3];
  aero_float step_x[3];
  aero_float step_y[3];
} AeroCamera;

AERO_ASSERT_LAYOUT(AeroCamera, 48);

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
  aero_float pixel_angle;  /* radians across one pixel in the middle of the image */
} AeroFrame;

AERO_ASSERT_LAYOUT(AeroFrame, 76);

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

/* What every rendering kernel is launched with. */
typedef struct AeroLaunch {
  AeroFrame frame;
  AeroTile tile;
} AeroLaunch;

AERO_ASSERT_LAYOUT(AeroLaunch, 116);

#endif
