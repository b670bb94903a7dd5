#include "atmosphere/droplets.clh"
#include "probe.clh"

__kernel void probe_droplet_phase(__global const float* cosines, const float asymmetry,
                                  __global float* phase) {
  STORE(droplet_phase(LOAD(cosines), asymmetry), phase);
}

/* Stores the share of light per steradian that droplets scatter by both of their lobes. */
__kernel void probe_droplet_lobes(__global const float* cosines, __global float* share) {
  const lane_float cosine = LOAD(cosines);
  STORE(droplet_peak(cosine) + droplet_wide(cosine), share);
}

/* Stores the light that droplets scatter towards the eye, once and more often. */
__kernel void probe_droplet_light(__global const float* to_sun, __global const float* behind,
                                  __global const float* seen, __global const float* cosines,
                                  const float level, __global float* light) {
  CloudDepths at;
  at.to_sun = LOAD(to_sun);
  at.behind = LOAD(behind);
  at.seen = LOAD(seen);
  STORE(droplet_light(&at, LOAD(cosines), level, (lane_int)-1), light);
}
