#include "ambient.clh"
#include "camera.clh"

/* A ray of every hit of a tile towards the sky: open[block] is 1 where it meets nothing that is
 * near, else 0. Every BUNDLE-th work-item works on that many blocks together. */
__kernel void trace_ambient_rays(const AeroLaunch launch, __global const AeroScene* scene,
                                 __global const AeroBvhNode* nodes,
                                 __global const AeroTriangle* triangles,
                                 __global const AeroInstance* instances, __global const float* grid,
                                 __global const AeroFace* faces,
                                 __global const AeroVertex* vertices, __global const Hit* hits,
                                 __global lane_float* open) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= launch.tile.block_count) return;
  const uint count = min((uint)BUNDLE, launch.tile.block_count - first);
  const AeroLaunch task = launch;
  const World world = make_world(nodes, triangles, instances, grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const float reach = scene->sky.ambient_reach;
  TracedPacket packets[BUNDLE];
  for (uint i = 0u; i < BUNDLE; ++i) {
    const Hit hit = i < count ? hits[first + i] : no_hit();
    const PixelPacket packet = pixel_packet(&task.tile, first + i);
    const Ray eye = generate_rays(&task.frame, &packet);
    const LightSample at = light_sample(&task.frame, &packet);
    const ShadowPoint point = shadow_point(&world.grid, &meshes, &hit);
    const Ray ray = ambient_ray(&point, &hit, &eye, &at, reach);
    start_packet(packets + i, &ray);
  }
  trace_bundle(&world, packets, TRACE_ANY_FROM_ABOVE);
  for (uint i = 0u; i < count; ++i) {
    const lane_int free = lane_mask(packets[i].hit.triangle == NO_TRIANGLE);
    open[first + i] = lane_select(free, (lane_float)1.0f, (lane_float)0.0f);
  }
}
