#ifndef AEROSTAT_SHARED_FILM_PIXEL_H
#define AEROSTAT_SHARED_FILM_PIXEL_H

#include "layout.h"

/* Samples are taken in batches of so many, from whose spread the noise of a pixel is judged; from
 * AERO_LEAST_SAMPLES on, and every as many further, pixels whose noise is small are converged. */
#define AERO_BATCH_SAMPLES 4
#define AERO_LEAST_SAMPLES 16

/* Sums over the samples of one pixel, and what its nearest sample met. Cleared to distance = +inf
 * and zero elsewhere. */
typedef struct AeroFilmPixel {
  aero_float radiance[3];
  aero_float coverage; /* samples that hit something */
  aero_float distance;
  aero_float normal[3];
  aero_uint object;
  aero_uint samples;
  aero_uint converged; /* 1: takes no further samples */
  aero_float batch;    /* luminance of the batch under way */
  aero_float squares;  /* of the luminances of whole batches */
} AeroFilmPixel;

AERO_ASSERT_LAYOUT(AeroFilmPixel, 52);

/* When a pixel of a film is sure: noise^2 <= scale (luminance + floor). */
typedef struct AeroConvergence {
  aero_float scale, floor;
  aero_uint width, height; /* of the film, pixels */
} AeroConvergence;

AERO_ASSERT_LAYOUT(AeroConvergence, 16);

#endif
