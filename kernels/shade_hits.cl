#include "atmosphere/cloud_march.clh"
#include "film/film.clh"
#include "integrator/local.clh"
#include "sample/sampling.clh"

/* Adds the radiance of a tile's eye rays to the film. */
__kernel void shade_hits(const AeroLaunch launch, __global const AeroScene* scene,
                         __global const AeroSkyCell* sky_table,
                         __global const AeroChartWord* cloud_chart, __global const uint* texels,
                         __global const AeroInstance* instances, __global const float* grid,
                         __global const AeroFace* faces, __global const AeroVertex* vertices,
                         __global const Hit* hits, __global const lane_uint* visible,
                         __global const AmbientFound* found, __global AeroFilmPixel* film) {
  const uint block = (uint)get_global_id(0);
  if (block >= launch.tile.block_count) return;
  const AeroLaunch task = launch;
  const SceneView view = scene_view(scene, sky_table, cloud_chart, texels);
  PixelPacket packet = pixel_packet(&task.tile, block);
  skip_converged(film, &task.film, task.tile.first_sample, &packet);
  if (!lane_any(packet.active)) return;
  const Ray ray = generate_rays(&task.frame, &packet);
  const Hit hit = hits[block];
  /* The way from the eye through air and clouds counts from the place of the terrain. */
  const lane_float lead = (lane_float)task.frame.camera.lead, distance = hit.t + lead;
  Ray way = ray;
  way.origin = place_of(scene, madd3(ray.origin, ray.direction, -lead));
  const lane_int met = lane_mask(hit.triangle != NO_TRIANGLE);

  const lane_float zero = (lane_float)0.0f;
  Lane3 radiance = lane3(zero, zero, zero);
  lane_uint object = (lane_uint)AERO_OBJECT_SKY;
  const SampleNumbers at = sample_numbers(&task.frame, &packet);
  if (!lane_all(met)) radiance = sky_radiance(&view, &way, at.w);
  if (lane_any(met)) {
    const HeightGrid ground = height_grid(grid);
    const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
    HitTriangle triangle = load_hit_triangle(&ground, &meshes, &hit);
    load_texture_coordinates(scene, &meshes, &hit, &triangle);
    AmbientFound around = all_free();
    if (scene->sky.ambient_reach > 0.0f) around = found[block];
    const RayCone cone = eye_cone(&task.frame);
    const SurfacePoint point =
        surface_point(scene, &triangle, &ray, &hit, cone_across(&cone, distance));
    const Lane3 surface = shade_hit(&view, &point, &triangle, &ray, &hit, visible[block], &around);
    radiance = select3(met, through_air(&view, surface, &way, distance, at.w), radiance);
    object = lane_select(met, triangle.object, object);
  }
  if (scene->sky.cumulus.extinction > 0.0f) {
    radiance = behind_clouds(&view, radiance, &way, distance, cloud_angle(&task.frame), at.w);
  }

  Samples samples;
  store3(samples.radiance, radiance);
  samples.distance.lanes = distance;
  samples.object.lanes = object;
  samples.x.lanes = packet.x;
  samples.y.lanes = packet.y;
  add_to_film(film, &task, &samples);
}
