#include "camera/camera.clh"
#include "geometry/ray_cone.clh"
#include "light/mirrored.clh"
#include "light/shadow.clh"
#include "material/materials.clh"

/* A kernel for scenes with models from files. It finds out what water and models mirror. */

/* Returns the mirrored direction of an eye ray: at water by a random wave, and at models by a facet
 * whose slope is as random as the material is rough. */
inline Lane3 mirrored_direction(__global const AeroScene* scene, const ShadowWork* work, Lane3 eye,
                                lane_int water, const SampleNumbers* at) {
  Lane3 by_wave = reflect3(eye, chosen_wave(scene->water.wave_slope, at));
  by_wave.y = fabs(by_wave.y);
  const Lane3 smooth = normalize3(interpolate3(work->point.normals, &work->hit));
  const Lane3 facing = select3(lane_mask(dot3(smooth, eye) > 0.0f), neg3(smooth), smooth);
  const lane_float rough = lane_gather_of(scene->materials, work->point.material, roughness);
  const lane_float y = 1.0f - 2.0f * at->u;
  const lane_float level = sqrt(lane_max(1.0f - y * y, (lane_float)0.0f));
  const lane_float turn = (2.0f * M_PI_F) * at->v;
  const Lane3 aside = lane3(level * cos(turn), y, level * sin(turn));
  const Lane3 facet = normalize3(madd3(facing, aside, 0.5f * rough * rough));
  const Lane3 by_facet = reflect3(eye, facet);
  /* A facet at the edge may mirror into the surface. Then the ray leaves along it. */
  const lane_float below = lane_min(dot3(by_facet, facing), (lane_float)0.0f);
  const Lane3 lifted = normalize3(madd3(by_facet, facing, 0.01f - 1.02f * below));
  return select3(water, by_wave, lifted);
}

/* Returns the albedo of a surface as its mirror image shows it. Water mirrors the sky itself. */
inline Lane3 mirrored_albedo(const Surface* surface) {
  const lane_int water = lane_mask(surface->point.kind == AERO_MATERIAL_WATER);
  if (!lane_any(water)) return surface->material.albedo;
  const lane_float one = (lane_float)1.0f;
  const Lane3 wet =
      mix3(surface->material.albedo, lane3(one, one, one), water_reflectance(surface));
  return select3(water, wet, surface->material.albedo);
}

/* Finds what the rays of a bundle have met, and whether the sun shines there. */
inline void look_at_hits(const SceneView* view, const World* world, const MeshArrays* meshes,
                         const AeroLaunch* task, const ShadowWork* work,
                         const TracedPacket* packets, const lane_int* asked, Mirrored* seen) {
  __global const AeroScene* scene = view->numbers;
  TracedPacket to_sun[BUNDLE];
  for (int i = 0; i < BUNDLE; ++i) {
    const Hit* hit = &packets[i].hit;
    seen[i].there = asked[i] & lane_mask(hit->triangle != NO_TRIANGLE);
    seen[i].sunlit = (lane_float)0.0f;
    seen[i].albedo = lane3((lane_float)0.0f, (lane_float)0.0f, (lane_float)0.0f);
    Ray ray = packets[i].ray;
    ray.t_max = (lane_float)-1.0f;
    if (lane_any(seen[i].there)) {
      const RayCone cone = eye_cone(&task->frame);
      HitTriangle triangle = load_hit_triangle(&world->grid, meshes, hit);
      load_texture_coordinates(scene, meshes, hit, &triangle);
      const lane_float distance = lane_select(seen[i].there, hit->t, (lane_float)0.0f);
      const lane_float across = cone_across(&cone, work[i].hit.t + distance);
      const SurfacePoint point = surface_point(scene, &triangle, &packets[i].ray, hit, across);
      const Surface surface = surface_at(view, &point);
      seen[i].albedo = mirrored_albedo(&surface);
      const lane_float facing = dot3(surface.material.normal, lane3_from(scene->sky.sun_direction));
      /* Metal scatters no sunlight. It mirrors what is around it, for which the sky stands. */
      seen[i].sunlit = lane_max(facing, (lane_float)0.0f) * (1.0f - surface.material.metallic);
      const ShadowPoint from = shadow_point_of(&triangle, hit);
      ray = shadow_ray(&from, hit, work[i].to_sun, (lane_float)INFINITY);
      const lane_int lit = seen[i].there & lane_mask(seen[i].sunlit > 0.0f);
      ray.t_max = lane_select(lit, ray.t_max, (lane_float)-1.0f);
    }
    start_packet(to_sun + i, &ray);
  }
  if (!casts_shadows(scene, LIGHT_SUN)) return;
  trace_bundle(world, to_sun, TRACE_ANY_FROM_ABOVE);
  for (int i = 0; i < BUNDLE; ++i) {
    const lane_int dark = lane_mask(to_sun[i].hit.triangle != NO_TRIANGLE);
    seen[i].sunlit = lane_select(dark, (lane_float)0.0f, seen[i].sunlit);
  }
}

/* Writes what water and models mirror at the hits of a tile into the words of the lights that
 * arrive there. Every BUNDLE-th work-item traces BUNDLE blocks together. */
__kernel void look_into_mirrors(const AeroLaunch launch, __global const AeroScene* scene,
                                __global const uint* texels, __global const AeroBvhNode* nodes,
                                __global const AeroTriangle* triangles,
                                __global const AeroInstance* instances, __global const float* grid,
                                __global const AeroFace* faces, __global const AeroVertex* vertices,
                                __global const Hit* hits, __global lane_uint* visible) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= launch.tile.block_count) return;
  const uint count = min((uint)BUNDLE, launch.tile.block_count - first);
  const AeroLaunch task = launch;
  const World world = make_world(nodes, triangles, instances, grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const SceneView view = scene_view(scene, 0, 0, texels);
  ShadowWork work[BUNDLE];
  if (!start_shadows(scene, &world, &meshes, &task, first, count, hits, work)) return;
  TracedPacket packets[BUNDLE];
  lane_int asked[BUNDLE], any = (lane_int)0;
  lane_float number[BUNDLE];
  for (int i = 0; i < BUNDLE; ++i) {
    const lane_uint kind = lane_gather_uint_of(scene->materials, work[i].point.material, kind);
    const lane_int water = lane_mask(kind == AERO_MATERIAL_WATER);
    asked[i] = work[i].active & (water | lane_mask(kind == AERO_MATERIAL_MODEL));
    any |= asked[i];
    const PixelPacket pixels = pixel_packet(&task.tile, first + (uint)i);
    const Ray eye = generate_rays(&task.frame, &pixels);
    const SampleNumbers at = sample_numbers(&task.frame, &pixels);
    number[i] = at.w;
    const Lane3 mirrored = mirrored_direction(scene, work + i, eye.direction, water, &at);
    Ray ray = shadow_ray(&work[i].point, &work[i].hit, mirrored, (lane_float)INFINITY);
    ray.t_max = lane_select(asked[i], ray.t_max, (lane_float)-1.0f);
    start_packet(packets + i, &ray);
  }
  if (!lane_any(any)) return;
  trace_bundle(&world, packets, TRACE_NEAREST);
  Mirrored seen[BUNDLE];
  look_at_hits(&view, &world, &meshes, &task, work, packets, asked, seen);
  for (uint i = 0u; i < count; ++i) {
    const lane_uint before = visible[first + i];
    const lane_uint word = (before & MIRRORED_LIGHTS) | mirrored_word(seen + i, number[i]);
    visible[first + i] = lane_select(asked[i], word, before);
  }
}
