#include "camera/camera.clh"
#include "light/ambient.clh"

/* Traces rays from every hit of a tile towards the sky, and writes their results to found[block].
 * Every BUNDLE-th work-item works on BUNDLE blocks together. */
__kernel void trace_ambient_rays(const AeroLaunch launch, __global const AeroScene* scene,
                                 __global const AeroBvhNode* nodes,
                                 __global const AeroTriangle* triangles,
                                 __global const AeroInstance* instances, __global const float* grid,
                                 __global const AeroFace* faces,
                                 __global const AeroVertex* vertices, __global const Hit* hits,
                                 __global AmbientFound* found) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= launch.tile.block_count) return;
  const uint count = min((uint)BUNDLE, launch.tile.block_count - first);
  const AeroLaunch task = launch;
  const World world = make_world(nodes, triangles, instances, grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const uint parts = ambient_parts(task.frame.samples);
  lane_int met = (lane_int)0;
  for (uint i = 0u; i < count; ++i) met |= lane_mask(hits[first + i].triangle != NO_TRIANGLE);
  if (!lane_any(met)) return; /* nobody reads what was found in the sky */
  AmbientWork work[BUNDLE];
  for (uint i = 0u; i < BUNDLE; ++i) {
    const Hit hit = i < count ? hits[first + i] : no_hit();
    work[i] = start_ambient(scene, &world, &meshes, &task, hit, first + i);
  }
  for (uint part = 0u; part < parts; ++part) {
    lane_int any = (lane_int)0;
    for (uint i = 0u; i < BUNDLE; ++i) any |= asks_for_part(&work[i].plan, part);
    if (!lane_any(any)) break;
    TracedPacket packets[BUNDLE];
    for (uint i = 0u; i < BUNDLE; ++i) {
      start_ambient_rays(scene, &task.frame, work + i, part, parts, packets + i);
    }
    trace_bundle(&world, packets, TRACE_ANY_FROM_ABOVE);
    for (uint i = 0u; i < BUNDLE; ++i) add_ambient(&scene->sky, packets + i, part, work + i);
  }
  for (uint i = 0u; i < count; ++i) {
    found[first + i] = found_of(work + i, parts, ambient_stride(task.frame.samples));
  }
}
