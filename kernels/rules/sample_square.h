#ifndef AEROSTAT_RULES_PIXEL_FILTER_H
#define AEROSTAT_RULES_PIXEL_FILTER_H

#include "camera.h"
#include "rules/rules.h"

/* Where in or around its pixel a sample looks. The device traces rays there, and the host chooses
 * the shift of the pattern by it. */

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

/* Returns an offset in pixels drawn from the tent filter by inverting its distribution. Sampling in
 * proportion to the filter makes every sample count the same (Ernst et al., "Filter Importance
 * Sampling", 2006), so a sample is added to its own pixel only. */
AERO_RULE lane_float tent_offset(lane_float u) {
  const lane_float low = sqrt(2.0f * u) - 1.0f;
  const lane_float high = 1.0f - sqrt(lane_max(2.0f - 2.0f * u, (lane_float)0.0f));
  return lane_select(lane_mask(u < 0.5f), low, high);
}

/* Returns an offset in pixels drawn from a normal distribution with a sigma of half a pixel, cut
 * off at three sigma. Its quantile is a rational approximation (Abramowitz and Stegun 26.2.23,
 * error below 4.5e-4 sigma). */
AERO_RULE lane_float gaussian_offset(lane_float u) {
  const float tail = 1.3499e-3f; /* share of the distribution beyond three sigma on one side */
  const lane_float p = lane_fma(u, (lane_float)(1.0f - 2.0f * tail), (lane_float)tail);
  const lane_float t = sqrt(-2.0f * log(lane_min(p, 1.0f - p)));
  const lane_float above =
      lane_fma(t, lane_fma(t, (lane_float)0.010328f, (lane_float)0.802853f), (lane_float)2.515517f);
  const lane_float below = lane_fma(
      t,
      lane_fma(t, lane_fma(t, (lane_float)0.001308f, (lane_float)0.189269f), (lane_float)1.432788f),
      (lane_float)1.0f);
  return 0.5f * copysign(t - above / below, u - 0.5f);
}

/* Writes to dx and dy where in or around its pixel a sample looks, in pixels from the pixel's
 * centre. */
AERO_RULE void filter_offset(const AeroFrame* frame, lane_uint sample, lane_float* dx,
                             lane_float* dy) {
  if (frame->samples <= 1u) {
    *dx = *dy = (lane_float)0.0f;
    return;
  }
  lane_float u, v;
  sample_square(frame, sample, &u, &v);
  if (frame->filter == AERO_FILTER_TENT) {
    *dx = tent_offset(u);
    *dy = tent_offset(v);
  } else if (frame->filter == AERO_FILTER_GAUSSIAN) {
    *dx = gaussian_offset(u);
    *dy = gaussian_offset(v);
  } else {
    *dx = u - 0.5f;
    *dy = v - 0.5f;
  }
  *dx = (*dx - frame->filter_mean[0]) * frame->filter_scale;
  *dy = (*dy - frame->filter_mean[1]) * frame->filter_scale;
}

AERO_RULES_END

#endif
