#include "film/film.clh"
#include "material/materials.clh"

/* Adds the albedos and normals of what a tile's eye rays hit to the guides of a denoiser. `hits`
 * are those of the eye rays. */
__kernel void note_guides(const AeroLaunch launch, __global const AeroScene* scene,
                          __global const uint* texels, __global const AeroInstance* instances,
                          __global const float* grid, __global const AeroFace* faces,
                          __global const AeroVertex* vertices, __global const Hit* hits,
                          __global const AeroFilmPixel* film, __global AeroFilmGuide* guides) {
  const uint block = (uint)get_global_id(0);
  if (block >= launch.tile.block_count) return;
  const AeroLaunch task = launch;
  PixelPacket packet = pixel_packet(&task.tile, block);
  skip_converged(film, &task.film, task.tile.first_sample, &packet);
  const Hit hit = hits[block];
  const lane_int met = packet.active & lane_mask(hit.triangle != NO_TRIANGLE);
  if (!lane_any(met)) return;
  const HeightGrid ground = height_grid(grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const Ray ray = generate_rays(&task.frame, &packet);
  const RayCone cone = eye_cone(&task.frame);
  const lane_float distance = hit.t + (lane_float)task.frame.camera.lead;
  const SceneView view = scene_view(scene, 0, 0, texels);
  const Surface surface =
      hit_surface(&view, &ground, &meshes, &ray, &hit, cone_across(&cone, distance));
  const lane_float zero = (lane_float)0.0f;
  const Lane3 none = lane3(zero, zero, zero);
  GuideSamples samples;
  store3(samples.albedo, select3(met, surface_albedo(&surface), none));
  store3(samples.normal, select3(met, surface.material.normal, none));
  samples.x.lanes = packet.x;
  samples.y.lanes = packet.y;
  add_to_guides(film, guides, &task, &samples);
}
