#include "camera.clh"
#include "shadow.clh"

/* Shadow rays from the hits of a tile to every light: bit i of visible[block] is set where light i
 * arrives. */
__kernel void trace_shadow_rays(const AeroLaunch launch, __global const AeroScene* scene,
                                __global const AeroBvhNode* nodes,
                                __global const AeroTriangle* triangles,
                                __global const AeroFace* faces, __global const AeroVertex* vertices,
                                __global const Hit* hits, __global lane_uint* visible) {
  const uint block = (uint)get_global_id(0);
  if (block >= launch.tile.block_count) return;
  const Hit hit = hits[block];
  const lane_int active = lane_mask(hit.triangle != NO_TRIANGLE);
  if (!lane_any(active)) {
    visible[block] = (lane_uint)0u;
    return;
  }
  const Face face = load_face(faces, hit.triangle);
  const ShadowPoint point = shadow_point(vertices, &face, &hit);
  visible[block] = visible_lights(scene, nodes, triangles, &point, &hit, active);
}
