#include "camera/camera.clh"
#include "probe.clh"

__kernel void probe_packets(const AeroTile tile, __global uint* x, __global uint* y,
                            __global uint* sample, __global int* active) {
  const AeroTile task = tile;
  const PixelPacket packet = pixel_packet(&task, (uint)get_global_id(0));
  STORE(packet.x, x);
  STORE(packet.y, y);
  STORE(packet.sample, sample);
  STORE(packet.active, active);
}

/* Stores the points in the unit square and the offsets of samples in any order. */
__kernel void probe_samples(const AeroFrame frame, __global const uint* samples, __global float* uv,
                            __global float* offset) {
  const AeroFrame task = frame;
  const lane_uint sample = LOAD(samples);
  lane_float u, v, dx, dy;
  sample_square(&task, sample, &u, &v);
  sample_offset(&task, sample, &dx, &dy);
  STORE(u, uv);
  STORE(v, uv + PLANE);
  STORE(dx, offset);
  STORE(dy, offset + PLANE);
}

__kernel void probe_rays(const AeroLaunch launch, __global float* origin, __global float* direction,
                         __global float* t_max) {
  const AeroLaunch task = launch;
  const PixelPacket packet = pixel_packet(&task.tile, (uint)get_global_id(0));
  const Ray ray = generate_rays(&task.frame, &packet);
  store3_planes(ray.origin, origin);
  store3_planes(ray.direction, direction);
  STORE(ray.t_max, t_max);
}
