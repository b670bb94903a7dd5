#ifndef AEROSTAT_SHARED_FILM_PIXEL_H
#define AEROSTAT_SHARED_FILM_PIXEL_H

#include "layout.h"

/* Samples are taken in batches of AERO_BATCH_SAMPLES, and the noise of a pixel is judged by the
 * spread of its batches. After AERO_LEAST_SAMPLES samples, and after each further
 * AERO_LEAST_SAMPLES, pixels with little noise are marked as converged. */
#define AERO_BATCH_SAMPLES 4
#define AERO_LEAST_SAMPLES 16

/* Sums over the samples of one pixel, and the values of its nearest sample. A cleared pixel has a
 * distance of +inf and zeros elsewhere. */
typedef struct AeroFilmPixel {
  aero_float radiance[3];
  aero_float coverage; /* number of samples that hit something */
  aero_float distance;
  aero_uint object;
  aero_uint samples;
  aero_uint converged; /* 1 if the pixel takes no further samples */
  aero_float batch;    /* luminance of the unfinished batch */
  aero_float squares;  /* sum of the squared luminances of whole batches */
} AeroFilmPixel;

AERO_ASSERT_LAYOUT(AeroFilmPixel, 40);

/* Sums over the samples of one pixel that guide a denoiser. They are kept apart from the film,
 * because most pictures need none. A sample of the sky adds zeros. */
typedef struct AeroFilmGuide {
  aero_float albedo[3];
  aero_float normal[3];
} AeroFilmGuide;

AERO_ASSERT_LAYOUT(AeroFilmGuide, 24);

/* The condition under which a pixel is sure: noise^2 <= scale (luminance + floor). */
typedef struct AeroConvergence {
  aero_float scale, floor;
  aero_uint width, height; /* size of the film, pixels */
} AeroConvergence;

AERO_ASSERT_LAYOUT(AeroConvergence, 16);

#endif
