#include "atmosphere/cloud_march.clh"
#include "film/film.clh"
#include "light/shade.clh"
#include "sample/sampling.clh"

/* Radiance of a tile's eye rays, added to the film. */
__kernel void shade_hits(const AeroLaunch launch, __global const AeroScene* scene,
                         __global const AeroInstance* instances, __global const float* grid,
                         __global const AeroFace* faces, __global const AeroVertex* vertices,
                         __global const Hit* hits, __global const lane_uint* visible,
                         __global const AmbientFound* found, __global AeroFilmPixel* film) {
  const uint block = (uint)get_global_id(0);
  if (block >= launch.tile.block_count) return;
  const AeroLaunch task = launch;
  PixelPacket packet = pixel_packet(&task.tile, block);
  skip_converged(film, &task.film, task.tile.first_sample, &packet);
  if (!lane_any(packet.active)) return;
  const Ray ray = generate_rays(&task.frame, &packet);
  const Hit hit = hits[block];
  /* From the eye through air and clouds, by places. */
  const lane_float lead = (lane_float)task.frame.camera.lead, distance = hit.t + lead;
  Ray way = ray;
  way.origin = place_of(scene, madd3(ray.origin, ray.direction, -lead));
  const lane_int met = lane_mask(hit.triangle != NO_TRIANGLE);

  const lane_float zero = (lane_float)0.0f;
  Lane3 radiance = lane3(zero, zero, zero);
  Lane3 normal = lane3(zero, zero, zero);
  lane_uint object = (lane_uint)AERO_OBJECT_SKY;
  if (!lane_all(met)) radiance = sky_radiance(scene, &way);
  if (lane_any(met)) {
    const HeightGrid ground = height_grid(grid);
    const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
    const HitTriangle triangle = load_hit_triangle(&ground, &meshes, &hit);
    AmbientFound around;
    around.free = (lane_float)1.0f;
    around.facing = zero;
    if (scene->sky.ambient_reach > 0.0f) around = found[block];
    Lane3 shading_normal;
    const lane_float across = pixel_across(&task.frame, distance);
    const Lane3 surface = shade_hit(scene, &meshes, &triangle, &ray, &hit, across, visible[block],
                                    &around, &shading_normal);
    radiance = select3(met, through_air(scene, surface, &way, distance), radiance);
    normal = select3(met, shading_normal, normal);
    object = lane_select(met, triangle.object, object);
  }
  if (scene->sky.cumulus.extinction > 0.0f) {
    const LightSample at = light_sample(&task.frame, &packet);
    /* A pixel of parallel rays counts as one seen a kilometre away. */
    const float angle = task.frame.pixel_angle + 1e-3f * task.frame.pixel_width;
    radiance = behind_clouds(scene, radiance, &way, distance, angle, at.w);
  }

  Samples samples;
  store3(samples.radiance, radiance);
  store3(samples.normal, normal);
  samples.distance.lanes = distance;
  samples.object.lanes = object;
  samples.x.lanes = packet.x;
  samples.y.lanes = packet.y;
  add_to_film(film, &task, &samples);
}

/* Empties the film. */
__kernel void clear_film(__global AeroFilmPixel* film, const uint pixels) {
  const uint i = (uint)get_global_id(0);
  if (i >= pixels) return;
  AeroFilmPixel empty = {
      {0.0f, 0.0f, 0.0f}, 0.0f, INFINITY, {0.0f, 0.0f, 0.0f}, AERO_OBJECT_SKY, 0u, 0u, 0.0f, 0.0f};
  film[i] = empty;
}

/* Marks as converged the pixels that have samples enough. */
__kernel void mark_converged(__global AeroFilmPixel* film, const AeroConvergence convergence) {
  const uint i = (uint)get_global_id(0);
  const AeroConvergence asked = convergence;
  if (i >= asked.width * asked.height) return;
  if (has_converged(film, i, &asked)) film[i].converged = 1u;
}
