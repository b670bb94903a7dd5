#include "camera/camera.clh"
#include "light/shadow.clh"

/* Traces shadow rays from the hits of a tile to every light. Bit i of visible[block] is set if
 * light i arrives. Every BUNDLE-th work-item traces BUNDLE blocks together. */
__kernel void trace_shadow_rays(const AeroLaunch launch, __global const AeroScene* scene,
                                __global const AeroBvhNode* nodes,
                                __global const AeroTriangle* triangles,
                                __global const AeroInstance* instances, __global const float* grid,
                                __global const AeroFace* faces, __global const AeroVertex* vertices,
                                __global const Hit* hits, __global lane_uint* visible) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= launch.tile.block_count) return;
  const uint count = min((uint)BUNDLE, launch.tile.block_count - first);
  const World world = make_world(nodes, triangles, instances, grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const AeroLaunch task = launch;
  ShadowWork work[BUNDLE];
  if (start_shadows(scene, &world, &meshes, &task, first, count, hits, work)) {
    find_visible_lights(scene, &world, work);
    find_mirrored_land(scene, &world, &task, first, work);
  }
  for (uint i = 0u; i < count; ++i) visible[first + i] = work[i].visible;
}
