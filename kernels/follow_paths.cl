#include "film/film.clh"
#include "integrator/path.clh"

/* Begins the paths of a tile with its eye rays. */
__kernel void start_paths(const AeroLaunch launch, __global const AeroFilmPixel* film,
                          __global PathState* paths) {
  const uint block = (uint)get_global_id(0);
  if (block >= launch.tile.block_count) return;
  const AeroLaunch task = launch;
  PixelPacket packet = pixel_packet(&task.tile, block);
  skip_converged(film, &task.film, task.tile.first_sample, &packet);
  paths[block] = start_paths_of(&task, &packet);
}

/* Finds the nearest hits of paths. Every BUNDLE-th work-item traces BUNDLE blocks together. */
__kernel void extend_paths(const uint blocks, __global const AeroBvhNode* nodes,
                           __global const AeroTriangle* triangles,
                           __global const AeroInstance* instances, __global const float* grid,
                           __global const PathState* paths, __global Hit* hits) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= blocks) return;
  const uint count = min((uint)BUNDLE, blocks - first);
  const World world = make_world(nodes, triangles, instances, grid);
  TracedPacket packets[BUNDLE];
  for (uint i = 0u; i < BUNDLE; ++i) {
    if (i < count) {
      const Ray ray = paths[first + i].path.ray;
      start_packet(packets + i, &ray);
    } else {
      switch_off(packets + i);
    }
  }
  trace_bundle(&world, packets, TRACE_NEAREST);
  for (uint i = 0u; i < count; ++i) hits[first + i] = packets[i].hit;
}

/* Adds what paths find at their hits, chooses rays to lights, and lets the paths go on. The hits
 * are surface number `bounce` of each path; the eye's is number 0. */
__kernel void scatter_at_hits(const AeroLaunch launch, const uint bounce,
                              __global const AeroScene* scene,
                              __global const AeroSkyCell* sky_table,
                              __global const AeroSkyImportance* sky_importance,
                              __global const AeroChartWord* cloud_chart,
                              __global const uint* texels, __global const AeroInstance* instances,
                              __global const float* grid, __global const AeroFace* faces,
                              __global const AeroVertex* vertices, __global const Hit* hits,
                              __global PathState* paths) {
  const uint block = (uint)get_global_id(0);
  if (block >= launch.tile.block_count) return;
  PathState state = paths[block];
  const lane_int on = lane_mask(state.path.ray.t_max >= 0.0f);
  if (!lane_any(on)) {
    for (int i = 0; i < LIGHT_RAYS; ++i) {
      paths[block].lights[i].ray.t_max = (lane_float)-1.0f;
    }
    return;
  }
  const AeroLaunch task = launch;
  const SceneView view = scene_view(scene, sky_table, cloud_chart, texels);
  const PixelPacket packet = pixel_packet(&task.tile, block);
  const PathNumbers numbers = path_numbers(&task.frame, &packet, bounce);
  const Hit hit = hits[block];
  const lane_int met = on & lane_mask(hit.triangle != NO_TRIANGLE);
  /* The way of an eye ray through air and clouds begins at the eye. */
  const lane_float lead = (lane_float)(bounce == 0u ? task.frame.camera.lead : 0.0f);
  const lane_float distance = hit.t + lead;
  Ray way = state.path.ray;
  way.origin = place_of(scene, madd3(way.origin, way.direction, -lead));
  const float angle = bounce == 0u ? cloud_angle(&task.frame) : PATH_CLOUD_ANGLE;
  pass_clouds_and_air(&view, &way, distance, angle, numbers.clouds, on, &state);
  add_sky(&view, sky_importance, &way, bounce, numbers.clouds, &state, on & ~met);
  for (int i = 0; i < LIGHT_RAYS; ++i) state.lights[i] = no_light_ray();

  if (lane_any(met)) {
    const HeightGrid ground = height_grid(grid);
    const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
    HitTriangle triangle = load_hit_triangle(&ground, &meshes, &hit);
    load_texture_coordinates(scene, &meshes, &hit, &triangle);
    const SurfacePoint seen = surface_point(scene, &triangle, &state.path.ray, &hit,
                                            cone_across(&state.path.cone, distance));
    if (bounce == 0u) note_first_hit(triangle.object, distance, met, &state);
    const Surface surface = surface_at(&view, &seen);
    const Lane3 emitted = emitted_radiance(scene, &surface, state.lit_by_burners);
    add_where(met, mul3(state.path.throughput, emitted), &state.radiance);
    if (bounce <= scene->bounces) {
      ShadowPoint point = shadow_point_of(&triangle, &hit);
      if (scene->shading == AERO_SHADING_FLAT) flatten_point(&point);
      if (!(without_light_rays(scene) && scene->sky.sun_spread > 0.0f)) {
        state.lights[RAY_TO_SUN] =
            ray_to_sun(&view, &surface, &point, &hit, state.path.throughput, &numbers.sun, met);
      }
      if (seeks_sky(scene, sky_importance)) {
        state.lights[RAY_TO_SKY] = ray_to_sky(&view, sky_importance, &surface, &point, &hit,
                                              state.path.throughput, &numbers, met);
      }
      const Lane3 burners = burner_radiance(scene, &surface);
      add_where(met, mul3(state.path.throughput, burners), &state.radiance);
      if (scene->light_count > 0u) {
        state.lights[RAY_TO_LAMP] =
            ray_to_lamp(&view, &surface, &point, &hit, state.path.throughput, numbers.lamp, met);
      }
      scatter_paths(scene, &surface, &point, &hit, &numbers, bounce, met, &state);
    }
  }
  const lane_int last = (lane_int)(bounce > scene->bounces ? -1 : 0);
  state.path.ray.t_max = lane_select(met & ~last, state.path.ray.t_max, (lane_float)-1.0f);
  paths[block] = state;
}

/* Adds the lights that nothing hides from the paths' surfaces. */
__kernel void trace_light_rays(const uint blocks, const uint light,
                               __global const AeroBvhNode* nodes,
                               __global const AeroTriangle* triangles,
                               __global const AeroInstance* instances, __global const float* grid,
                               __global PathState* paths) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= blocks) return;
  const uint count = min((uint)BUNDLE, blocks - first);
  const World world = make_world(nodes, triangles, instances, grid);
  TracedPacket packets[BUNDLE];
  lane_int asked[BUNDLE];
  start_light_rays(paths, first, count, light, packets, asked);
  trace_bundle(&world, packets, TRACE_ANY_FROM_ABOVE);
  finish_light_rays(paths, first, count, light, packets, asked);
}

/* Adds the radiance of a tile's paths to the film. */
__kernel void add_paths(const AeroLaunch launch, __global const PathState* paths,
                        __global AeroFilmPixel* film) {
  const uint block = (uint)get_global_id(0);
  if (block >= launch.tile.block_count) return;
  const AeroLaunch task = launch;
  const PixelPacket packet = pixel_packet(&task.tile, block);
  const PathState state = paths[block];
  Samples samples;
  store3(samples.radiance, state.radiance);
  samples.distance.lanes = state.distance;
  samples.object.lanes = state.object;
  samples.x.lanes = packet.x;
  samples.y.lanes = packet.y;
  add_to_film(film, &task, &samples);
}
