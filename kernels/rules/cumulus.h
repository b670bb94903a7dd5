#ifndef AEROSTAT_RULES_CUMULUS_H
#define AEROSTAT_RULES_CUMULUS_H

#include "rules/noise.h"

/* Where heaped clouds stand and how high they tower. The device computes their density by these
 * rules, and the host charts where there is none. Heights are in heights of the layer over the
 * clouds' bases. The numbers are chosen by eye. */

AERO_RULES_BEGIN

/* Difference of the coverage noise between the edge of a cloud and its thick middle. */
#define CUMULUS_SPREAD 0.36f
/* Size of bulges, and the height of the tallest towers with their bulges. */
#define CUMULUS_BULGE 0.36f
#define CUMULUS_TALLEST 1.25f
/* The lowest height with any density, and the width of the edge over which density rises. */
#define CUMULUS_LOWEST (-0.1f)
#define CUMULUS_EDGE 0.1f

/* The coverage noise is the noise of single heaps plus this share of that of fields of clouds. Both
 * lie over the plane. `size` is the width of a cloud in metres. */
#define CUMULUS_FIELD_SHARE 0.6f
AERO_RULE Fbm cumulus_heaps(float size, aero_uint seed) {
  return fbm_of(seed + 11u, 2.4f * size, 5, 0.5f);
}
AERO_RULE Fbm cumulus_fields(float size, aero_uint seed) {
  return fbm_of(seed, 9.0f * size, 1, 0.5f);
}

/* Returns how high clouds tower where the coverage noise exceeds its threshold by `over` times
 * CUMULUS_SPREAD. The value is below 0 where there are no clouds, and falls with the distance to
 * the next one. */
AERO_RULE lane_float cumulus_towers_over(lane_float over) {
  const lane_float grown = 2.0f * over / (1.0f + lane_max(over, (lane_float)0.0f));
  return lane_min(grown, (lane_float)(CUMULUS_TALLEST - 0.5f * CUMULUS_BULGE));
}

/* The excess of the coverage noise over its threshold at which clouds tower to CUMULUS_LOWEST. This
 * inverts cumulus_towers_over(): there is no density below it. */
#define CUMULUS_LEAST_EXCESS (CUMULUS_SPREAD * (0.5f * CUMULUS_LOWEST))

AERO_RULES_END

#endif
