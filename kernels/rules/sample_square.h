#ifndef AEROSTAT_RULES_SAMPLE_SQUARE_H
#define AEROSTAT_RULES_SAMPLE_SQUARE_H

#include "camera.h"
#include "rules/rules.h"

/* Where in its pixel a sample looks. The device traces rays there, and the host takes the mean of
 * the pattern by it. */

AERO_RULES_BEGIN

/* Steps from sample to sample, in parts of 2^32 (sample/sequence.clh). */
#define SEQUENCE_PIXEL_U 3545107369u
#define SEQUENCE_PIXEL_V 2701144391u

/* Returns a number inside (0, 1) from the upper 24 bits. It lies in the middle of a step,
 * so that 0 does not occur. */
AERO_RULE lane_float inner_unit_interval(lane_uint bits) {
  return lane_fma(lane_from_uint(bits >> 8), 5.9604644775390625e-8f, 2.98e-8f);
}

/* Writes to u and v the point of a sample in the unit square. The points are a rank-1 lattice that
 * is the same in every pixel, so that an edge is drawn by the same steps along its whole length. u
 * takes the middles of `samples` equal strata, in the order of a stride that spreads early samples.
 * v follows the golden ratio, shifted by the seed. Where pixels may stop after their first samples,
 * the points are a sequence instead, which is even from any sample to any other. */
AERO_RULE void sample_square(const AeroFrame* frame, lane_uint sample, lane_float* u,
                             lane_float* v) {
  if (frame->progressive) {
    *u = inner_unit_interval(sample * SEQUENCE_PIXEL_U + frame->sample_shift + 0x80000000u);
    *v = inner_unit_interval(sample * SEQUENCE_PIXEL_V + frame->sample_shift + 0x80000000u);
    return;
  }
  const lane_uint stratum = (sample * frame->sample_stride) % frame->samples;
  *u = (lane_from_uint(stratum) + 0.5f) / (float)frame->samples;
  *v = inner_unit_interval(stratum * 2654435769u + frame->sample_shift);
}

/* Writes to dx and dy where in its pixel a sample looks, in pixels from the pixel's centre. */
AERO_RULE void sample_offset(const AeroFrame* frame, lane_uint sample, lane_float* dx,
                             lane_float* dy) {
  if (frame->samples <= 1u) {
    *dx = *dy = (lane_float)0.0f;
    return;
  }
  lane_float u, v;
  sample_square(frame, sample, &u, &v);
  *dx = (u - 0.5f - frame->sample_mean[0]) * frame->sample_spread;
  *dy = (v - 0.5f - frame->sample_mean[1]) * frame->sample_spread;
}

AERO_RULES_END

#endif
