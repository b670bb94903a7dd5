#ifndef AEROSTAT_RULES_SOLID_NOISE_H
#define AEROSTAT_RULES_SOLID_NOISE_H

#include "rules/hash.h"
#include "rules/noise.h"

/* Perlin noise in space. Gradients point to the middles of a cube's twelve edges (K. Perlin,
 * "Improving Noise", 2002). */

AERO_RULES_BEGIN

/* Returns the ramp of one lattice point, the product of its gradient and the offset (x, y, z),
 * without making the gradient. `bits` are what solid_hash() takes. The ramp is the sum of two of
 * the three offsets, each with either sign. */
AERO_RULE lane_float ramp_value(lane_uint bits, lane_float x, lane_float y, lane_float z) {
  const lane_uint hash = solid_hash(bits);
  /* The gradient has no part along x below the first of these hashes, none along z from the second
   * on, and none along y between them. */
  const lane_float first = lane_select(lane_mask(hash < 0x55560000u), y, x);
  const lane_float second = lane_select(lane_mask(hash >= 0xAAAB0000u), y, z);
  return lane_as_float(lane_as_uint(first) ^ (hash << 31)) +
         lane_as_float(lane_as_uint(second) ^ ((hash << 30) & 0x80000000u));
}

/* Returns the mix of the ramps of a cell's corners at the point (x, y, z) of the cell, each 0 to 1.
 * Bit 0 of a corner's number is x, bit 1 is y and bit 2 is z. */
AERO_RULE lane_float mixed_ramps(const lane_float* ramp, lane_float x, lane_float y, lane_float z) {
  const lane_float wx = fade(x), wy = fade(y), wz = fade(z);
  const lane_float e00 = lane_fma(ramp[1] - ramp[0], wx, ramp[0]);
  const lane_float e10 = lane_fma(ramp[3] - ramp[2], wx, ramp[2]);
  const lane_float e01 = lane_fma(ramp[5] - ramp[4], wx, ramp[4]);
  const lane_float e11 = lane_fma(ramp[7] - ramp[6], wx, ramp[6]);
  const lane_float front = lane_fma(e10 - e00, wy, e00);
  const lane_float rear = lane_fma(e11 - e01, wy, e01);
  return lane_fma(rear - front, wz, front);
}

/* Returns the noise at the point (x, y, z), each 0 to 1, of the cell that begins at the lattice
 * point (ix, iy, iz). */
AERO_RULE lane_float solid_noise_in_cell(lane_int ix, lane_int iy, lane_int iz, lane_float x,
                                         lane_float y, lane_float z, aero_uint seed) {
  const lane_float x1 = x - 1.0f, y1 = y - 1.0f, z1 = z - 1.0f;
  const lane_uint left = hash_column(seed, ix), right = hash_column(seed, ix + 1);
  const lane_uint row = lane_as_uint(iy) * SOLID_ROW, layer = lane_as_uint(iz) * SOLID_LAYER;
  const lane_uint near_low = row + layer, near_high = near_low + SOLID_ROW;
  const lane_uint far_low = near_low + SOLID_LAYER, far_high = near_high + SOLID_LAYER;
  lane_float ramp[8];
  ramp[0] = ramp_value(left ^ near_low, x, y, z);
  ramp[1] = ramp_value(right ^ near_low, x1, y, z);
  ramp[2] = ramp_value(left ^ near_high, x, y1, z);
  ramp[3] = ramp_value(right ^ near_high, x1, y1, z);
  ramp[4] = ramp_value(left ^ far_low, x, y, z1);
  ramp[5] = ramp_value(right ^ far_low, x1, y, z1);
  ramp[6] = ramp_value(left ^ far_high, x, y1, z1);
  ramp[7] = ramp_value(right ^ far_high, x1, y1, z1);
  return mixed_ramps(ramp, x, y, z);
}

/* Parameters of an fBm in space. If `ridges` is not 0, each octave is folded at zero, which makes
 * creases. */
typedef struct SolidFbm {
  aero_uint seed;
  float wavelength;
  int octaves;
  float gain;
  int ridges;
} SolidFbm;

AERO_RULE SolidFbm solid_fbm_of(aero_uint seed, float wavelength, int octaves, float gain,
                                int ridges) {
  SolidFbm fbm;
  fbm.seed = seed;
  fbm.wavelength = wavelength;
  fbm.octaves = octaves;
  fbm.gain = gain;
  fbm.ridges = ridges;
  return fbm;
}

/* Returns by how much the lattice of octave i is shifted along each axis, so that the lattice
 * points of different octaves lie apart. */
AERO_RULE float octave_shift(int i) {
  return 0.37f * (float)(i + 1);
}

/* Returns a value of the noise folded at zero. */
AERO_RULE lane_float folded(lane_float noise) {
  return lane_fma(fabs(noise), (lane_float)-2.0f, (lane_float)0.5f);
}

/* Points of a footprint are distributed normally, with this many footprints as the standard
 * deviation along each axis of the surface. The pixel's own filter has half a pixel. */
#define FOOTPRINT_SIGMA 0.4f

/* Variances of the noise, plain and folded, and of each component of the folded noise's gradient.
 * These and the correlations below were measured on random cells and random planes through them. */
#define SOLID_NOISE_VARIANCE 0.0729f
#define SOLID_NOISE_FOLDED_VARIANCE 0.0978f
#define SOLID_NOISE_FOLDED_SLOPE_VARIANCE 1.99f

/* Returns the correlation of an octave's value at a point with that at other points of a footprint
 * around it. The error is below 0.02. */
AERO_RULE lane_float value_correlation(SolidFbm fbm, lane_float footprint) {
  const lane_float x = footprint * (FOOTPRINT_SIGMA / fbm.wavelength);
  return 1.0f / lane_fma(x * x, (lane_float)(fbm.ridges ? 17.5f : 7.0f), (lane_float)1.0f);
}

/* Returns the same of the gradient. Where the noise is folded, the gradient also jumps at creases.
 * Most footprints have none, and the others are few enough to be left to the samples: their
 * variance, if all footprints had its mean, would put snow on the smoothest walls. */
AERO_RULE lane_float slope_correlation(SolidFbm fbm, lane_float footprint) {
  const lane_float x = footprint * (FOOTPRINT_SIGMA / fbm.wavelength);
  return 1.0f / lane_fma(x * x, (lane_float)10.0f, (lane_float)1.0f);
}

/* What varies inside of a footprint: the variances of an fBm's value and of each component of its
 * gradient per metre, of what resolved() leaves of it. The gradient's is that of folded noise. */
typedef struct SolidVariance {
  lane_float value, slope;
} SolidVariance;

AERO_RULE SolidVariance variance_inside(SolidFbm fbm, lane_float footprint) {
  const float value_variance = fbm.ridges ? SOLID_NOISE_FOLDED_VARIANCE : SOLID_NOISE_VARIANCE;
  SolidVariance sum;
  sum.value = sum.slope = (lane_float)0.0f;
  float amplitude = 1.0f;
  for (int i = 0; i < fbm.octaves; ++i) {
    const lane_float weight = amplitude * resolved(fbm.wavelength, footprint);
    const lane_float value = value_correlation(fbm, footprint);
    const lane_float slope = slope_correlation(fbm, footprint);
    const lane_float steep = weight * (1.0f / fbm.wavelength);
    sum.value =
        lane_fma(weight * weight, value_variance * lane_fma(-value, value, 1.0f), sum.value);
    sum.slope =
        lane_fma(steep * steep, SOLID_NOISE_FOLDED_SLOPE_VARIANCE * lane_fma(-slope, slope, 1.0f),
                 sum.slope);
    fbm.wavelength *= 0.5f;
    amplitude *= fbm.gain;
  }
  return sum;
}

AERO_RULES_END

#endif
