/* The same traversal, counting what it does. */
#define AERO_COUNTERS
#include "ray_buffer.clh"
#include "traverse.clh"

__kernel void count_rays(__global const AeroBvhNode* nodes, __global const AeroTriangle* triangles,
                         __global const float* rays, const uint any_hit, const uint blocks,
                         __global uint* counters) {
#ifdef BUNDLE
  const uint block = (uint)get_global_id(0);
  if (block % BUNDLE != 0u || block >= blocks) return;
  TraceCounts counts;
  counts.nodes = counts.leaves = counts.triangles = 0u;
  TracedPacket packets[BUNDLE];
  Ray ray;
  for (uint i = 0u; i < BUNDLE; ++i) {
    ray = read_rays(rays, min(block + i, blocks - 1u));
    if (block + i >= blocks) ray.t_max = (lane_float)-1.0f;
    start_packet(packets + i, &ray);
    if (block + i < blocks) {
      counters[(block + i) * 4u] = lane_any(lane_mask(ray.t_max >= 0.0f)) ? 1u : 0u;
      counters[(block + i) * 4u + 1u] = counters[(block + i) * 4u + 2u] =
          counters[(block + i) * 4u + 3u] = 0u;
    }
  }
  if (any_hit != 0u) {
    trace_bundle(nodes, triangles, packets, 1, &counts);
  } else {
    trace_bundle(nodes, triangles, packets, 0, &counts);
  }
#else
  const uint block = (uint)get_global_id(0);
  if (block >= blocks) return;
  const Ray ray = read_rays(rays, block);
  TraceCounts counts;
  counts.nodes = counts.leaves = counts.triangles = 0u;
  if (any_hit != 0u) {
    trace_packet(nodes, triangles, &ray, 1, &counts);
  } else {
    trace_packet(nodes, triangles, &ray, 0, &counts);
  }
  counters[block * 4u] = lane_any(lane_mask(ray.t_max >= 0.0f)) ? 1u : 0u;
#endif
  counters[block * 4u + 1u] = counts.nodes;
  counters[block * 4u + 2u] = counts.leaves;
  counters[block * 4u + 3u] = counts.triangles;
}
