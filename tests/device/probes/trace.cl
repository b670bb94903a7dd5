#include "bvh/traverse.clh"
#include "probe.clh"

inline Ray load_ray(__global const float* origins, __global const float* directions,
                    __global const float* t_max) {
  Ray ray;
  ray.origin = load3(origins);
  ray.direction = load3(directions);
  ray.t_max = LOAD(t_max);
  return ray;
}

/* Traces rays through the tree. `tuv` receives three planes. */
__kernel void probe_trace(__global const AeroBvhNode* nodes, __global const AeroTriangle* triangles,
                          __global const AeroInstance* instances, __global const float* grid,
                          __global const float* origins, __global const float* directions,
                          __global const float* t_max, const int wanted, __global float* tuv,
                          __global uint* slots) {
  const Ray ray = load_ray(origins, directions, t_max);
  const World world = make_world(nodes, triangles, instances, grid);
  const Hit hit = trace_packet(&world, &ray, wanted);
  store3_planes(lane3(hit.t, hit.u, hit.v), tuv);
  STORE(hit.triangle, slots);
  STORE(hit.instance, slots + PLANE);
}

/* Loads and stores the packet `packet` of the rays. */
#if LANES == 1
#define LOAD_PACKET(array) ((array)[packet])
#define STORE_PACKET(value, array) ((array)[packet] = (value))
#else
#define LOAD_PACKET(array) AERO_JOIN(vload, LANES)(packet, (array))
#define STORE_PACKET(value, array) AERO_JOIN(vstore, LANES)((value), packet, (array))
#endif

/* Traces rays in bundles through the tree. The number of packets must be a multiple of BUNDLE. */
__kernel void probe_bundle(__global const AeroBvhNode* nodes,
                           __global const AeroTriangle* triangles,
                           __global const AeroInstance* instances, __global const float* grid,
                           __global const float* origins, __global const float* directions,
                           __global const float* t_max, const int wanted, __global float* tuv,
                           __global uint* slots) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u) return;
  TracedPacket packets[BUNDLE];
  for (uint i = 0u; i < BUNDLE; ++i) {
    const uint packet = first + i;
    Ray ray;
    ray.origin = lane3(LOAD_PACKET(origins), LOAD_PACKET(origins + PLANE),
                       LOAD_PACKET(origins + 2u * PLANE));
    ray.direction = lane3(LOAD_PACKET(directions), LOAD_PACKET(directions + PLANE),
                          LOAD_PACKET(directions + 2u * PLANE));
    ray.t_max = LOAD_PACKET(t_max);
    start_packet(packets + i, &ray);
  }
  const World world = make_world(nodes, triangles, instances, grid);
  trace_bundle(&world, packets, wanted);
  for (uint i = 0u; i < BUNDLE; ++i) {
    const uint packet = first + i;
    STORE_PACKET(packets[i].hit.t, tuv);
    STORE_PACKET(packets[i].hit.u, tuv + PLANE);
    STORE_PACKET(packets[i].hit.v, tuv + 2u * PLANE);
    STORE_PACKET(packets[i].hit.triangle, slots);
    STORE_PACKET(packets[i].hit.instance, slots + PLANE);
  }
}

inline void hit_triangle(__global const AeroTriangle* triangle, uint slot, const Ray* ray,
                         const RayFrame* frame, const SlabRay* slab_ray, Hit* hit) {
  const Crossing crossing = cross_triangle(triangle, frame);
  take_hit(&crossing, (lane_uint)slot, enter_triangle(triangle, slab_ray), ray, frame, hit);
}

/* Tests every ray against the same triangles in their order, without a tree. */
__kernel void probe_triangles(__global const AeroTriangle* triangles, const uint count,
                              __global const float* origins, __global const float* directions,
                              __global const float* t_max, const uint first_slot,
                              __global float* tuv, __global uint* slots) {
  const Ray ray = load_ray(origins, directions, t_max);
  const RayFrame frame = ray_frame(&ray, lane_mask(ray.t_max >= 0.0f));
  Hit hit = no_hit();
  const SlabRay slab_ray = make_slab_ray(&ray, 1.0f);
  for (uint i = 0u; i < count; ++i) {
    hit_triangle(triangles + i, first_slot + i, &ray, &frame, &slab_ray, &hit);
  }
  store3_planes(lane3(hit.t, hit.u, hit.v), tuv);
  STORE(hit.triangle, slots);
}

/* Tests each ray against a triangle of its own in every lane. `tuv` and `slots` have an entry for
 * each ray. */
__kernel void probe_pairs(__global const AeroTriangle* triangles, __global const float* origins,
                          __global const float* directions, __global const float* t_max,
                          __global float* tuv, __global uint* slots) {
  const Ray ray = load_ray(origins, directions, t_max);
  const RayFrame frame = ray_frame(&ray, lane_mask(ray.t_max >= 0.0f));
  const SlabRay slab_ray = make_slab_ray(&ray, 1.0f);
  const uint first = (uint)get_global_id(0) * LANES;
  Hit mine = no_hit();
  for (uint i = 0u; i < LANES; ++i) {
    Hit hit = no_hit();
    hit_triangle(triangles + (first + i), first + i, &ray, &frame, &slab_ray, &hit);
    const lane_int own = lane_mask(LANE_INDEX == (lane_uint)i);
    mine.t = lane_select(own, hit.t, mine.t);
    mine.u = lane_select(own, hit.u, mine.u);
    mine.v = lane_select(own, hit.v, mine.v);
    mine.triangle = lane_select(own, hit.triangle, mine.triangle);
  }
  store3_planes(lane3(mine.t, mine.u, mine.v), tuv);
  STORE(mine.triangle, slots);
}
