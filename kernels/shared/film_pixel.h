#ifndef AEROSTAT_SHARED_FILM_PIXEL_H
#define AEROSTAT_SHARED_FILM_PIXEL_H

#include "layout.h"

/* Sums over the samples of one pixel, and what its nearest sample met. Cleared to distance = +inf
 * and zero elsewhere. */
typedef struct AeroFilmPixel {
  aero_float radiance[3];
  aero_float coverage; /* samples that hit something */
  aero_float distance;
  aero_float normal[3];
  aero_uint object;
} AeroFilmPixel;

AERO_ASSERT_LAYOUT(AeroFilmPixel, 36);

#endif
