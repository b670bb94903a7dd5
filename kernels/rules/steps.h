#ifndef AEROSTAT_RULES_STEPS_H
#define AEROSTAT_RULES_STEPS_H

#include "rules/rules.h"

/* Steps, of which many rules are made. */

AERO_RULES_BEGIN

AERO_REAL_RULE lane_real clamp01(lane_real x) {
  return lane_min(lane_max(x, (lane_real)0.0f), (lane_real)1.0f);
}

/* Returns 0 for x below lo, 1 above hi, and 3 t^2 - 2 t^3 between them, where t runs from 0 to
 * 1. */
AERO_REAL_RULE lane_real smooth_step(lane_real lo, lane_real hi, lane_real x) {
  const lane_real t = clamp01((x - lo) / (hi - lo));
  return t * t * (3.0f - 2.0f * t);
}

/* Returns the mean of smooth_step() over values around x that are spread with this variance. The
 * step is the distribution function of a density that has a variance of a twentieth of its width
 * squared. Spread values convolve that density, so their variances add, and the mean is about a
 * wider step. For normally distributed values the error is below 0.032. */
AERO_RULE lane_float spread_step(float lo, float hi, lane_float x, lane_float variance) {
  const float width = hi - lo;
  const lane_float wide = sqrt(lane_fma(variance, (lane_float)20.0f, (lane_float)(width * width)));
  const lane_float t = clamp01((x - 0.5f * (lo + hi)) / wide + 0.5f);
  return t * t * (3.0f - 2.0f * t);
}

AERO_RULES_END

#endif
