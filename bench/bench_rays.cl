#include "bounce.clh"
#include "ray_buffer.clh"

__kernel void write_camera_rays(const AeroLaunch launch, __global float* rays) {
  const uint block = (uint)get_global_id(0);
  if (block >= launch.tile.block_count) return;
  const AeroLaunch task = launch;
  const PixelPacket packet = pixel_packet(&task.tile, block);
  const Ray ray = generate_rays(&task.frame, &packet);
  write_rays(rays, block, &ray);
}

/* Writes rays that begin at hits. Lanes without a hit, and lanes that are not wanted, get a
 * negative t_max. */
inline void write_rays_of_hits(__global float* rays, uint block, Ray ray, const Hit* hit,
                               lane_int wanted) {
  const lane_int active = wanted & lane_mask(hit->triangle != NO_TRIANGLE);
  ray.t_max = lane_select(active, ray.t_max, (lane_float)-1.0f);
  write_rays(rays, block, &ray);
}

/* Writes the shadow rays to the sun from the hits of a tile. */
__kernel void write_shadow_rays(const AeroLaunch launch, __global const AeroScene* scene,
                                __global const AeroInstance* instances, __global const float* grid,
                                __global const AeroFace* faces, __global const AeroVertex* vertices,
                                __global const Hit* hits, __global float* rays) {
  const uint block = (uint)get_global_id(0);
  if (block >= launch.tile.block_count) return;
  const Hit hit = hits[block];
  const HeightGrid ground = height_grid(grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const ShadowPoint point = shadow_point(&ground, &meshes, &hit);
  const AeroLaunch task = launch;
  const PixelPacket packet = pixel_packet(&task.tile, block);
  const Lane3 to_light = shadow_sun(&scene->sky, &task.frame, &packet);
  const Ray ray = shadow_ray(&point, &hit, to_light, (lane_float)INFINITY);
  write_rays_of_hits(rays, block, ray, &hit, ~turned_away(&point, &hit, to_light));
}

/* Writes one bounce ray from each of the hits of a tile. */
__kernel void write_bounce_rays(const AeroLaunch launch, __global const AeroInstance* instances,
                                __global const float* grid, __global const AeroFace* faces,
                                __global const AeroVertex* vertices, __global const Hit* hits,
                                __global float* rays) {
  const uint block = (uint)get_global_id(0);
  if (block >= launch.tile.block_count) return;
  const AeroLaunch task = launch;
  const PixelPacket packet = pixel_packet(&task.tile, block);
  const Ray eye = generate_rays(&task.frame, &packet);
  const Hit hit = hits[block];
  const HeightGrid ground = height_grid(grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const ShadowPoint point = shadow_point(&ground, &meshes, &hit);
  const Ray ray = bounce_ray(&packet, &eye, &point, &hit);
  write_rays_of_hits(rays, block, ray, &hit, (lane_int)-1);
}

__kernel void trace_rays(__global const AeroBvhNode* nodes, __global const AeroTriangle* triangles,
                         __global const AeroInstance* instances, __global const float* grid,
                         __global const float* rays, const uint any_hit, const uint blocks,
                         __global Hit* hits) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= blocks) return;
  const World world = make_world(nodes, triangles, instances, grid);
  TracedPacket packets[BUNDLE];
  for (uint i = 0u; i < BUNDLE; ++i) {
    Ray ray = read_rays(rays, min(first + i, blocks - 1u));
    if (first + i >= blocks) ray.t_max = (lane_float)-1.0f;
    start_packet(packets + i, &ray);
  }
  if (any_hit != 0u) {
    trace_bundle(&world, packets, TRACE_ANY_FROM_ABOVE);
  } else {
    trace_bundle(&world, packets, TRACE_NEAREST);
  }
  for (uint i = 0u; i < BUNDLE && first + i < blocks; ++i) hits[first + i] = packets[i].hit;
}
