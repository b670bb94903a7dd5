#include "camera.clh"
#include "traverse.clh"

/* Eye rays of a tile: one packet a work-item, its closest hits into hits[block]. */
__kernel void trace_camera_rays(const AeroLaunch launch, __global const AeroBvhNode* nodes,
                                __global const AeroTriangle* triangles, __global Hit* hits) {
  const uint block = (uint)get_global_id(0);
  if (block >= launch.tile.block_count) return;
  const AeroFrame frame = launch.frame;
  const AeroTile tile = launch.tile;
  const PixelPacket packet = pixel_packet(&tile, block);
  const Ray ray = generate_rays(&frame, &packet);
  hits[block] = trace_packet(nodes, triangles, &ray, 0);
}
