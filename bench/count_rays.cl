/* The same traversal, counting what it does. */
#define AERO_COUNTERS
#include "ray_buffer.clh"
#include "traverse.clh"

__kernel void count_rays(__global const AeroBvhNode* nodes, __global const AeroTriangle* triangles,
                         __global const float* rays, const uint any_hit, const uint blocks,
                         __global uint* counters) {
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
  counters[block * 4u + 1u] = counts.nodes;
  counters[block * 4u + 2u] = counts.leaves;
  counters[block * 4u + 3u] = counts.triangles;
}
