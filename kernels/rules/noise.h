#ifndef AEROSTAT_RULES_NOISE_H
#define AEROSTAT_RULES_NOISE_H

#include "rules/steps.h"

/* What all noise is made of: how a cell of the lattice is blended, which waves a footprint leaves,
 * and how the octaves of fractals follow each other. */

AERO_RULES_BEGIN

/* Returns the weight of a cell's far side at the distance t, 0 to 1, from its near side. */
AERO_RULE lane_float fade(lane_float t) {
  return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

/* Returns the share, 0 to 1, of a wave of this length that survives at a pixel that covers
 * `footprint` metres. It is 1 from four footprints on and 0 below two (Nyquist). */
AERO_RULE lane_float resolved(float wavelength, lane_float footprint) {
  return clamp01(wavelength / (2.0f * footprint) - 1.0f);
}

/* The axes of an octave's lattice over the plane: a rotation, scaled by 1 / wavelength. The point
 * (x, z) of the plane has the lattice coordinates
 *   (along x - across z, across x + along z) */
typedef struct Octave {
  float along, across;
} Octave;

AERO_RULE Octave first_octave(float wavelength) {
  Octave octave;
  octave.along = 1.0f / wavelength;
  octave.across = 0.0f;
  return octave;
}

/* Returns the octave of twice the frequency, turned by the angle whose cosine is 0.8, so that no
 * lattice shows. */
AERO_RULE Octave next_octave(Octave octave) {
  Octave next;
  next.along = 2.0f * (0.8f * octave.along - 0.6f * octave.across);
  next.across = 2.0f * (0.6f * octave.along + 0.8f * octave.across);
  return next;
}

/* Parameters of an fBm. Each octave has half the wavelength and `gain` times the amplitude of the
 * one before it, and the next seed. The first octave has an amplitude of 1. */
typedef struct Fbm {
  aero_uint seed;
  float wavelength;
  int octaves;
  float gain;
} Fbm;

AERO_RULE Fbm fbm_of(aero_uint seed, float wavelength, int octaves, float gain) {
  Fbm fbm;
  fbm.seed = seed;
  fbm.wavelength = wavelength;
  fbm.octaves = octaves;
  fbm.gain = gain;
  return fbm;
}

AERO_RULES_END

#endif
