#ifndef AEROSTAT_RULES_CUMULUS_H
#define AEROSTAT_RULES_CUMULUS_H

#include "rules/noise.h"

/* Where heaped clouds stand and how high they tower. The device computes their density by these
 * rules, and the host charts where there is none. Heights are in heights of the layer over the
 * clouds' bases. The numbers are chosen by eye. */

AERO_RULES_BEGIN

/* Difference of the coverage noise between the edge of a cloud and its thick middle. Excess of the
 * noise over its threshold is counted in this unit. */
#define CUMULUS_SPREAD 0.36f
/* Size of bulges, as excess, which moves the sides, and as height, which lifts the tops. */
#define CUMULUS_BULGE 0.4f
#define CUMULUS_LIFT 0.16f
/* The height of the tallest towers, the lowest height with any density, and the width of the edge
 * over which density rises. */
#define CUMULUS_TALLEST 1.16f
#define CUMULUS_LOWEST (-0.1f)
#define CUMULUS_EDGE 0.06f

/* The coverage noise is the noise of single heaps plus this share of that of fields of clouds, and
 * plus this share of that of the turrets and rags of a heap. All of them lie over the plane. `size`
 * is the width of a cloud in metres. */
#define CUMULUS_FIELD_SHARE 0.6f
#define CUMULUS_RAG_SHARE 0.16f
AERO_RULE Fbm cumulus_heaps(float size, aero_uint seed) {
  return fbm_of(seed + 11u, 2.4f * size, 2, 0.5f);
}
AERO_RULE Fbm cumulus_fields(float size, aero_uint seed) {
  return fbm_of(seed, 9.0f * size, 1, 0.5f);
}
AERO_RULE Fbm cumulus_rags(float size, aero_uint seed) {
  return fbm_of(seed + 23u, 0.6f * size, 3, 0.5f);
}

/* Returns the share of the rags' noise that counts at an excess of the noise of fields and heaps.
 * Rags that stand by themselves have dissolved. The host's chart relies on values from 0 to 1. */
AERO_RULE lane_float cumulus_ragged(lane_float excess) {
  return clamp01(lane_fma(excess, (lane_float)1.5f, (lane_float)0.1f));
}

/* The height of towers at an excess of 1, if nothing limited it. */
#define CUMULUS_LIMIT 1.1f

/* Returns how high clouds tower at an excess of the coverage noise. The noise falls off around its
 * peaks as parabolas do, so that its root makes domes, and small ones are as round as large ones.
 * The value is below 0 where there are no clouds, and falls with the distance to the next one. */
AERO_RULE lane_float cumulus_towers(lane_float excess) {
  const lane_float grown = CUMULUS_LIMIT * sqrt(lane_max(excess, (lane_float)0.0f));
  const lane_float outside = 2.0f * lane_min(excess, (lane_float)0.0f);
  return lane_min(grown + outside, (lane_float)(CUMULUS_TALLEST - CUMULUS_LIFT));
}

/* Returns the excess at which clouds tower to a height: the inverse of cumulus_towers(). */
AERO_RULE lane_float cumulus_excess_of(lane_float height) {
  const lane_float within =
      lane_min(lane_max(height, (lane_float)0.0f), (lane_float)CUMULUS_TALLEST) *
      (1.0f / CUMULUS_LIMIT);
  return lane_fma(lane_min(height, (lane_float)0.0f), (lane_float)0.5f, within * within);
}

/* There is no density at lower excesses than this. Clouds there tower to CUMULUS_LOWEST. */
#define CUMULUS_LEAST_EXCESS (0.5f * CUMULUS_LOWEST)

/* Returns the share of bulges that counts at an excess. It is 0 at CUMULUS_LEAST_EXCESS, so that no
 * bulge floats where there is no cloud, and small clouds have small bulges. */
#define CUMULUS_BULGE_RISE 2.5f
AERO_RULE lane_float cumulus_bulging(lane_float excess) {
  return clamp01(CUMULUS_BULGE_RISE * (excess - CUMULUS_LEAST_EXCESS));
}

/* Returns the excess that clouds need to have any density at a height, if bulges add to it and to
 * the towers as much as they can. */
AERO_RULE lane_float cumulus_needed(lane_float height) {
  const lane_float level = cumulus_excess_of(height - CUMULUS_LIFT);
  /* This is the excess whose sum with its bulge is `level`, where clouds are thin. */
  const float rise = CUMULUS_BULGE_RISE * CUMULUS_BULGE;
  const lane_float thin = (level + rise * CUMULUS_LEAST_EXCESS) * (1.0f / (1.0f + rise));
  const lane_float needed = lane_max(level - CUMULUS_BULGE, lane_min(level, thin));
  return lane_max(needed, (lane_float)CUMULUS_LEAST_EXCESS);
}

/* Returns the density, 0 to 1, at a height under which the coverage noise has the given excess.
 * `folds` is the noise in space, whose mean is 0, and `edge` the height over which density rises.
 */
AERO_RULE lane_float cumulus_filled(lane_float excess, lane_float folds, lane_float height,
                                    lane_float edge) {
  /* Folds point inwards, so that what bulges out between them is round. Bases are nearly flat. */
  const lane_float inwards = cumulus_bulging(excess) * (folds + 0.15f);
  const lane_float bulged = lane_fma(inwards, (lane_float)-CUMULUS_BULGE, excess);
  const lane_float depth =
      lane_fma(inwards, (lane_float)-CUMULUS_LIFT, cumulus_towers(bulged) - height);
  const lane_float uneven = lane_fma(folds, (lane_float)-0.12f, height);
  const lane_float flat_base = smooth_step((lane_float)-0.04f, (lane_float)0.1f, uneven);
  /* Fragments have nearly dissolved. */
  const lane_float whole = clamp01(4.0f * bulged);
  return clamp01(depth / edge) * (flat_base * whole);
}

/* The share of light that droplets deflect widely (device/atmosphere/droplets.clh). */
#define DROPLET_WIDE_SHARE 0.49416f

/* Returns the share of sunlight that seems to come from the sun behind a cloud of this optical
 * depth: what goes straight on, and what the narrow peak deflects by hardly more than the sun's
 * disc. All other light that comes through is the cloud's own. */
AERO_RULE lane_float cumulus_transmittance(lane_float depth) {
  return exp(-DROPLET_WIDE_SHARE * depth);
}

AERO_RULES_END

#endif
