#include "material/drape.clh"
#include "probe.clh"

/* Stores the albedo of a picture at places, multiplied by the opacity, and then the opacity. */
__kernel void probe_drape(__global const AeroDrape* drape, __global const uint* texels,
                          __global const float* places, __global const float* footprints,
                          __global float* found) {
  const Drape seen = drape_at(drape, texels, load3(places), LOAD(footprints));
  store3_planes(seen.albedo, found);
  STORE(seen.opacity, found + 3u * PLANE);
}

/* Stores the albedo of ground of one colour under a picture. */
__kernel void probe_draped_ground(__global const AeroDrape* drape, __global const uint* texels,
                                  __global const float* places, __global const float* footprints,
                                  __global float* albedo) {
  const lane_float half_grey = (lane_float)0.5f;
  const Drape seen = drape_at(drape, texels, load3(places), LOAD(footprints));
  store3_planes(draped(lane3(half_grey, half_grey, half_grey), &seen), albedo);
}
