#ifndef AEROSTAT_RULES_HASH_H
#define AEROSTAT_RULES_HASH_H

#include "rules/rules.h"

/* Hashes of lattice points, in 32-bit arithmetic that wraps around. Signed coordinates are taken
 * modulo 2^32. The multipliers of the finalizer are those of C. Wellons, lowbias32. */

AERO_RULES_BEGIN

/* Returns the part of a lattice point's hash that depends on its column. `seeded` is the seed after
 * its multiplication. */
AERO_RULE lane_uint seeded_column(lane_uint seeded, lane_int ix) {
  lane_uint h = (lane_as_uint(ix) * 0x9E3779B1u) ^ seeded;
  h ^= h >> 16;
  h *= 0x7FEB352Du;
  return h ^ (h >> 15);
}
AERO_RULE lane_uint hash_column(aero_uint seed, lane_int ix) {
  return seeded_column((lane_uint)(seed * 0x85EBCA6Bu), ix);
}

AERO_RULE lane_uint hash_row(lane_uint column, lane_int iy) {
  lane_uint h = column ^ (lane_as_uint(iy) * 0xC2B2AE35u);
  h ^= h >> 16;
  h *= 0x7FEB352Du;
  h ^= h >> 15;
  return h * 0x846CA68Bu;
}

/* Returns the hash of a lattice point of the plane. */
AERO_RULE lane_uint lattice_hash(aero_uint seed, lane_int ix, lane_int iy) {
  return hash_row(hash_column(seed, ix), iy);
}

/* A lattice point in space has the hash
 *   solid_hash(hash_column(seed, ix) ^ (iy * SOLID_ROW + iz * SOLID_LAYER)) */
#define SOLID_ROW 0xC2B2AE35u
#define SOLID_LAYER 0x27D4EB2Fu

AERO_RULE lane_uint solid_hash(lane_uint bits) {
  const lane_uint hash = (bits ^ (bits >> 16)) * 0x7FEB352Du;
  return hash ^ (hash >> 15);
}

AERO_RULES_END

#endif
