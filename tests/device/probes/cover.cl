#include "material/cover.clh"
#include "probe.clh"

/* Stores the shares of land cover at places as planes, in the order of the classes. `noises` has
 * `broad` and `fine`. */
__kernel void probe_cover(__global const AeroCover* cover, __global const uint* texels,
                          __global const float* places, __global const float* noises,
                          __global const float* footprints, __global float* shares) {
  GroundNoise noise;
  noise.broad = LOAD(noises);
  noise.fine = LOAD(noises + PLANE);
  const CoverAt at = cover_at(&cover->map, texels, load3(places), &noise, LOAD(footprints));
  for (uint k = 0; k < AERO_COVER_CLASSES; ++k) STORE(at.share[k], shares + k * PLANE);
}

/* Stores the albedo of ground with land cover at places, and half grey where it ends. */
__kernel void probe_covered(__global const AeroCover* cover, __global const uint* texels,
                            __global const float* places, __global float* albedo) {
  const lane_float half_grey = (lane_float)0.5f, none = (lane_float)0.0f;
  GroundNoise noise;
  noise.broad = noise.fine = none;
  const CoverAt at = cover_at(&cover->map, texels, load3(places), &noise, (lane_float)1.0f);
  store3_planes(
      covered_albedo(cover, &at, lane3(half_grey, half_grey, half_grey), (lane_float)1.0f), albedo);
}
