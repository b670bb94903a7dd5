#include "bvh/traverse.clh"
#include "film/film.clh"

/* Traces the eye rays of a tile's pixels that are not converged, and writes their nearest hits to
 * hits[block]. Every BUNDLE-th work-item traces BUNDLE blocks together. */
__kernel void trace_camera_rays(const AeroLaunch launch, __global const AeroBvhNode* nodes,
                                __global const AeroTriangle* triangles,
                                __global const AeroInstance* instances, __global const float* grid,
                                __global const AeroFilmPixel* film, __global Hit* hits) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= launch.tile.block_count) return;
  const World world = make_world(nodes, triangles, instances, grid);
  const AeroFrame frame = launch.frame;
  const AeroTile tile = launch.tile;
  const AeroWindow window = launch.film;
  /* All packets of a tile hold the same samples, which have the same offsets from the pixel's
   * centre. */
  const PixelPacket block = pixel_packet(&tile, first);
  lane_float dx, dy;
  sample_offset(&frame, block.sample, &dx, &dy);
  TracedPacket packets[BUNDLE];
  for (uint i = 0u; i < BUNDLE; ++i) {
    /* Blocks beyond the tile's last one lie below the tile, and their lanes are off. */
    PixelPacket packet = pixel_packet(&tile, first + i);
    skip_converged(film, &window, tile.first_sample, &packet);
    const Ray ray = generate_offset_rays(&frame, &packet, dx, dy);
    start_packet(packets + i, &ray);
  }
  trace_bundle(&world, packets, TRACE_NEAREST);
  const uint count = min((uint)BUNDLE, tile.block_count - first);
  for (uint i = 0u; i < count; ++i) hits[first + i] = packets[i].hit;
}
