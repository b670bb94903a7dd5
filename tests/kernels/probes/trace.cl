#include "probe.clh"
#include "traverse.clh"

inline Ray load_ray(__global const float* origins, __global const float* directions,
                    __global const float* t_max) {
  Ray ray;
  ray.origin = load3(origins);
  ray.direction = load3(directions);
  ray.t_max = LOAD(t_max);
  return ray;
}

/* Rays through the tree; tuv receives three planes. */
__kernel void probe_trace(__global const AeroBvhNode* nodes, __global const AeroTriangle* triangles,
                          __global const float* origins, __global const float* directions,
                          __global const float* t_max, const int any_hit, __global float* tuv,
                          __global uint* slots) {
  const Ray ray = load_ray(origins, directions, t_max);
  const Hit hit = trace_packet(nodes, triangles, &ray, any_hit);
  store3_planes(lane3(hit.t, hit.u, hit.v), tuv);
  STORE(hit.triangle, slots);
}

/* Every ray against the same triangles in their order, without a tree. */
__kernel void probe_triangles(__global const AeroTriangle* triangles, const uint count,
                              __global const float* origins, __global const float* directions,
                              __global const float* t_max, const uint first_slot,
                              __global float* tuv, __global uint* slots) {
  const Ray ray = load_ray(origins, directions, t_max);
  const RayFrame frame = ray_frame(ray.direction);
  Hit hit = no_hit();
  for (uint i = 0u; i < count; ++i) hit_triangle(triangles + i, first_slot + i, &ray, &frame, &hit);
  store3_planes(lane3(hit.t, hit.u, hit.v), tuv);
  STORE(hit.triangle, slots);
}

/* Each ray against a triangle of its own, in every lane; `tuv` and `slots` are per ray. */
__kernel void probe_pairs(__global const AeroTriangle* triangles, __global const float* origins,
                          __global const float* directions, __global const float* t_max,
                          __global float* tuv, __global uint* slots) {
  const Ray ray = load_ray(origins, directions, t_max);
  const RayFrame frame = ray_frame(ray.direction);
  const uint first = (uint)get_global_id(0) * LANES;
  Hit mine = no_hit();
  for (uint i = 0u; i < LANES; ++i) {
    Hit hit = no_hit();
    hit_triangle(triangles + (first + i), first + i, &ray, &frame, &hit);
    const lane_int own = lane_mask(LANE_INDEX == (lane_uint)i);
    mine.t = lane_select(own, hit.t, mine.t);
    mine.u = lane_select(own, hit.u, mine.u);
    mine.v = lane_select(own, hit.v, mine.v);
    mine.triangle = lane_select(own, hit.triangle, mine.triangle);
  }
  store3_planes(lane3(mine.t, mine.u, mine.v), tuv);
  STORE(mine.triangle, slots);
}
