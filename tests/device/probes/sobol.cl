#include "light/sky_importance.clh"
#include "probe.clh"

/* Stores pair number `pair` of a tile's samples. */
__kernel void probe_path_pairs(const AeroLaunch launch, const uint pair, __global uint* pixels,
                               __global float* us, __global float* vs) {
  const AeroLaunch task = launch;
  const PixelPacket packet = pixel_packet(&task.tile, (uint)get_global_id(0));
  const PathSample sample = path_sample(&task.frame, &packet);
  const NumberPair numbers = path_pair(&sample, pair);
  STORE(packet.y * task.frame.width + packet.x, pixels);
  STORE(numbers.u, us);
  STORE(numbers.v, vs);
}

/* Stores the directions of the sky that two numbers choose, and their densities. */
__kernel void probe_sky_directions(__global const AeroScene* scene,
                                   __global const AeroSkyImportance* importance,
                                   __global const float* us, __global const float* vs,
                                   __global float* directions, __global float* densities) {
  NumberPair at;
  at.u = LOAD(us);
  at.v = LOAD(vs);
  const Lane3 direction = sample_sky_importance(scene, importance, &at);
  store3_planes(direction, directions);
  STORE(sky_importance_pdf(scene, importance, direction), densities);
}

/* Stores the probability densities with which sample_sky_importance() chooses given directions. */
__kernel void probe_sky_densities(__global const AeroScene* scene,
                                  __global const AeroSkyImportance* importance,
                                  __global const float* directions, __global float* densities) {
  STORE(sky_importance_pdf(scene, importance, load3(directions)), densities);
}
