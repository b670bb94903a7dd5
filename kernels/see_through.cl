#include "film/film.clh"
#include "integrator/path.clh"
#include "light/see_through.clh"

/* Kernels for scenes with surfaces that let some rays through, such as leaves that a texture cuts
 * out. Rays of the kernels in render.cl and paths.cl stop at the first surface. The first two
 * kernels here run after those and correct their hits; the other two run in place of them. */

/* Continues the eye rays of a tile behind surfaces that let them through. */
__kernel void pass_eye_rays(const AeroLaunch launch, __global const AeroScene* scene,
                            __global const uint* texels, __global const AeroBvhNode* nodes,
                            __global const AeroTriangle* triangles,
                            __global const AeroInstance* instances, __global const float* grid,
                            __global const AeroFace* faces, __global const AeroVertex* vertices,
                            __global Hit* hits) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= launch.tile.block_count) return;
  const uint count = min((uint)BUNDLE, launch.tile.block_count - first);
  const AeroLaunch task = launch;
  const World world = make_world(nodes, triangles, instances, grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const SceneView view = scene_view(scene, 0, 0, texels);
  SeenRays seen;
  for (uint i = 0u; i < BUNDLE; ++i) {
    const PixelPacket packet = pixel_packet(&task.tile, first + i);
    seen.ray[i] = generate_rays(&task.frame, &packet);
    seen.cone[i] = eye_cone(&task.frame);
    seen.hit[i] = i < count ? hits[first + i] : no_hit();
  }
  pass_surfaces(&view, &world, &meshes, &seen);
  for (uint i = 0u; i < count; ++i) hits[first + i] = seen.hit[i];
}

/* Continues the rays of paths behind surfaces that let them through. */
__kernel void pass_path_rays(const uint blocks, __global const AeroScene* scene,
                             __global const uint* texels, __global const AeroBvhNode* nodes,
                             __global const AeroTriangle* triangles,
                             __global const AeroInstance* instances, __global const float* grid,
                             __global const AeroFace* faces, __global const AeroVertex* vertices,
                             __global const PathState* paths, __global Hit* hits) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= blocks) return;
  const uint count = min((uint)BUNDLE, blocks - first);
  const World world = make_world(nodes, triangles, instances, grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const SceneView view = scene_view(scene, 0, 0, texels);
  SeenRays seen;
  for (uint i = 0u; i < BUNDLE; ++i) {
    const uint block = min(first + i, blocks - 1u);
    seen.ray[i] = paths[block].path.ray;
    seen.cone[i] = paths[block].path.cone;
    seen.hit[i] = i < count ? hits[block] : no_hit();
  }
  pass_surfaces(&view, &world, &meshes, &seen);
  for (uint i = 0u; i < count; ++i) hits[first + i] = seen.hit[i];
}

/* Does the same as trace_shadow_rays, but rays continue behind surfaces that let them through. */
__kernel void trace_shadow_rays_on(const AeroLaunch launch, __global const AeroScene* scene,
                                   __global const uint* texels, __global const AeroBvhNode* nodes,
                                   __global const AeroTriangle* triangles,
                                   __global const AeroInstance* instances,
                                   __global const float* grid, __global const AeroFace* faces,
                                   __global const AeroVertex* vertices, __global const Hit* hits,
                                   __global lane_uint* visible) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= launch.tile.block_count) return;
  const uint count = min((uint)BUNDLE, launch.tile.block_count - first);
  const AeroLaunch task = launch;
  const World world = make_world(nodes, triangles, instances, grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const SceneView view = scene_view(scene, 0, 0, texels);
  ShadowWork work[BUNDLE];
  if (start_shadows(scene, &world, &meshes, &task, first, count, hits, work)) {
    for (uint light = 0u; light <= scene->light_count; ++light) {
      TracedPacket packets[BUNDLE];
      lane_int towards[BUNDLE];
      start_light(scene, light, work, packets, towards);
      if (casts_shadows(scene, light)) {
        trace_bundle(&world, packets, TRACE_ANY_FROM_ABOVE);
        pass_light_rays(&view, &world, &meshes, packets);
        finish_light(light, packets, towards, work);
      } else {
        for (int i = 0; i < BUNDLE; ++i) work[i].visible |= (lane_uint)(1u << light);
      }
    }
    find_mirrored_land(scene, &world, &task, first, work);
  }
  for (uint i = 0u; i < count; ++i) visible[first + i] = work[i].visible;
}

/* Does the same as trace_light_rays, but rays continue behind surfaces that let them through. */
__kernel void trace_light_rays_on(const uint blocks, const uint light,
                                  __global const AeroScene* scene, __global const uint* texels,
                                  __global const AeroBvhNode* nodes,
                                  __global const AeroTriangle* triangles,
                                  __global const AeroInstance* instances,
                                  __global const float* grid, __global const AeroFace* faces,
                                  __global const AeroVertex* vertices, __global PathState* paths) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= blocks) return;
  const uint count = min((uint)BUNDLE, blocks - first);
  const World world = make_world(nodes, triangles, instances, grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const SceneView view = scene_view(scene, 0, 0, texels);
  TracedPacket packets[BUNDLE];
  lane_int asked[BUNDLE];
  start_light_rays(paths, first, count, light, packets, asked);
  trace_bundle(&world, packets, TRACE_ANY_FROM_ABOVE);
  pass_light_rays(&view, &world, &meshes, packets);
  finish_light_rays(paths, first, count, light, packets, asked);
}
