/* This kernel does the traversal of bench_rays.cl and counts its steps. */
#define AERO_COUNTERS
#include "bvh/traverse.clh"
#include "ray_buffer.clh"

__kernel void count_rays(__global const AeroBvhNode* nodes, __global const AeroTriangle* triangles,
                         __global const AeroInstance* instances, __global const float* grid,
                         __global const float* rays, const uint any_hit, const uint blocks,
                         __global uint* counters) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= blocks) return;
  const World world = make_world(nodes, triangles, instances, grid);
  TracedPacket packets[BUNDLE];
  uint live = 0u;
  for (uint i = 0u; i < BUNDLE; ++i) {
    Ray ray = read_rays(rays, min(first + i, blocks - 1u));
    if (first + i >= blocks) ray.t_max = (lane_float)-1.0f;
    start_packet(packets + i, &ray);
    live += packets[i].reach >= 0.0f ? 1u : 0u;
  }
  TraceCounts counts;
  counts.nodes = counts.leaves = counts.triangles = 0u;
  if (any_hit != 0u) {
    trace_bundle(&world, packets, TRACE_ANY_FROM_ABOVE, &counts);
  } else {
    trace_bundle(&world, packets, TRACE_NEAREST, &counts);
  }
  for (uint i = first; i < first + BUNDLE && i < blocks; ++i) {
    counters[i * 4u] = i == first ? live : 0u;
    counters[i * 4u + 1u] = i == first ? counts.nodes : 0u;
    counters[i * 4u + 2u] = i == first ? counts.leaves : 0u;
    counters[i * 4u + 3u] = i == first ? counts.triangles : 0u;
  }
}
