#include "probe.clh"
#include "sample/sampling.clh"

/* Stores the numbers of a tile's samples, and the points and directions that they choose. */
__kernel void probe_light_samples(const AeroLaunch launch, __global const float* axis,
                                  const float radius, __global uint* pixels, __global float* uvw,
                                  __global float* in_disc, __global float* by_cosine) {
  const AeroLaunch task = launch;
  const PixelPacket packet = pixel_packet(&task.tile, (uint)get_global_id(0));
  const SampleNumbers at = sample_numbers(&task.frame, &packet);
  STORE(packet.y * task.frame.width + packet.x, pixels);
  store3_planes(lane3(at.u, at.v, at.w), uvw);
  store3_planes(direction_in_disc(axis, radius, &at), in_disc);
  store3_planes(direction_by_cosine(lane3_from(axis), &at), by_cosine);
}
