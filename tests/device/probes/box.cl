#include "bvh/traverse.clh"
#include "probe.clh"

/* Tests every sixteen rays against one node, at every width. For each ray, bit c says whether child
 * c is hit. For each packet, bit c says whether child c is left after culling, together with the
 * eight lower bounds. Rays with a negative t_max are off. */
__kernel void probe_children(__global const AeroBvhNode* nodes, __global const float* origins,
                             __global const float* directions, __global const float* reaches,
                             __global uint* met, __global uint* kept, __global float* enters) {
  const size_t i = get_global_id(0);
  __global const AeroBvhNode* node = nodes + i * LANES / 16u;
  Ray ray;
  ray.origin = load3(origins);
  ray.direction = load3(directions);
  ray.t_max = LOAD(reaches);
  const SlabRay slab_ray = make_slab_ray(&ray, 1.0f);
  const Lane3 inverse = safe_inverse3(ray.direction);
  const PacketBounds bounds = packet_bounds(&ray.origin, &inverse, lane_mask(ray.t_max >= 0.0f));
  const float room = box_room(&bounds, farthest_corner(node, &bounds));
  ChildReach reach;
  kept[i] = cull_children(node, &bounds, room, lane_reduce_max(ray.t_max), &reach);
  vstore8(reach.enter, i, enters);
  lane_uint bits = (lane_uint)0u;
  for (uint c = 0u; c < AERO_BVH_WIDTH; ++c) {
    const Box box = box_of_child(node, c);
    lane_float entry;
    const lane_int hit = enter_box(box.lo, box.hi, &slab_ray, ray.t_max, &entry);
    bits |= lane_select(hit, (lane_uint)(1u << c), (lane_uint)0u);
  }
  STORE(bits, met);
}

/* Runs the same tests by frustums for packets whose rays make one. A packet that makes none keeps
 * the answers that are already stored. */
__kernel void probe_frustum(__global const AeroBvhNode* nodes, __global const float* origins,
                            __global const float* directions, __global const float* reaches,
                            __global uint* met, __global uint* kept, __global float* enters,
                            __global uint* frustums) {
  const size_t i = get_global_id(0);
  __global const AeroBvhNode* node = nodes + i * LANES / 16u;
  Ray ray;
  ray.origin = load3(origins);
  ray.direction = load3(directions);
  ray.t_max = LOAD(reaches);
  TracedPacket packet;
  start_packet(&packet, &ray);
  make_slab_rays(&packet, 1, 1.0f);
  Frustum frustum;
  frustums[i] = packet.reach >= 0.0f && make_frustum(&packet, 1, 1.0f, &frustum) ? 1u : 0u;
  if (frustums[i] == 0u) return;
  float8 enter;
  const FrustumBoxes boxes = node_boxes(node, &frustum);
  kept[i] = cull_by_frustum(&boxes, &frustum, packet.reach, &enter);
  vstore8(enter, i, enters);
  lane_uint bits = (lane_uint)0u;
  for (uint c = 0u; c < AERO_BVH_WIDTH; ++c) {
    const BoxPlanes box = child_planes(node, c, &frustum);
    lane_float entry;
    const lane_int hit = hit_box_by_slabs(&box, &packet.slab_ray, ray.t_max, &entry);
    bits |= lane_select(hit, (lane_uint)(1u << c), (lane_uint)0u);
  }
  STORE(bits, met);
}
