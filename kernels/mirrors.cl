#include "camera/camera.clh"
#include "geometry/ray_cone.clh"
#include "integrator/local.clh"
#include "light/mirrored.clh"
#include "light/shadow.clh"
#include "material/materials.clh"

/* A kernel for scenes with still water or models from files. It finds out what these mirror. */

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

/* The share of the sky that lies open before what mirrors show. Chosen by eye. */
#define MIRRORED_OPEN 0.7f

/* What a mirror shows at a point: its radiance without the sun, and what the sun adds if it arrives
 * there. */
typedef struct MirroredPoint {
  Lane3 dark, by_sun;
} MirroredPoint;

/* Returns the albedo of water and of models as their mirror image shows it. Mirrors within the
 * mirror are white. Metal scatters no sunlight, and the sky stands for what it mirrors. */
inline Lane3 mirrored_albedo(const Surface* surface) {
  const lane_int water = lane_mask(surface->point.kind == AERO_MATERIAL_WATER);
  if (!lane_any(water)) return surface->material.albedo;
  const lane_float one = (lane_float)1.0f;
  const Lane3 wet =
      mix3(surface->material.albedo, lane3(one, one, one), water_reflectance(surface));
  return select3(water, wet, surface->material.albedo);
}

/* Returns what a mirror shows of a surface. */
OUTLINED MirroredPoint mirrored_point(const SceneView* view, const Surface* surface) {
  __global const AeroScene* scene = view->numbers;
  const Material* material = &surface->material;
  const AmbientFound around = {(lane_float)MIRRORED_OPEN, (lane_float)0.0f};
  /* Lamps arrive, the sun does not. */
  const LocalLight light = local_light(view, surface, (lane_uint)(MIRRORED_LIGHTS & ~1u), &around);
  const Lane3 to_sun = lane3_from(scene->sky.sun_direction);
  const Lane3 sun = scale3(light.sun, light.sunlit * M_1_PI_F);
  MirroredPoint seen;
  seen.dark = local_solid(scene, surface, &light);
  seen.by_sun = sub3(lit_by(surface, to_sun, sun, (lane_float)1.0f),
                     lit_by(surface, to_sun, sun, (lane_float)0.0f));
  const lane_int other = lane_mask(surface->point.kind == AERO_MATERIAL_WATER) |
                         lane_mask(surface->point.kind == AERO_MATERIAL_MODEL);
  if (!lane_any(other)) return seen;
  const Lane3 albedo = mirrored_albedo(surface);
  const Lane3 sky = scale3(ambient_light(scene, material->normal), (lane_float)MIRRORED_OPEN);
  const lane_float facing = lane_max(dot3(material->normal, to_sun), (lane_float)0.0f);
  const Lane3 lit = scale3(sun, facing * (1.0f - material->metallic));
  seen.dark =
      select3(other, madd3(mul3(albedo, sky), material->emission, (lane_float)1.0f), seen.dark);
  seen.by_sun = select3(other, mul3(albedo, lit), seen.by_sun);
  return seen;
}

/* Finds what the rays of a bundle have met, and whether the sun shines there. */
inline void look_at_hits(const SceneView* view, const World* world, const MeshArrays* meshes,
                         const AeroLaunch* task, const ShadowWork* work,
                         const TracedPacket* packets, const lane_int* asked, Mirrored* seen) {
  __global const AeroScene* scene = view->numbers;
  const lane_float zero = (lane_float)0.0f;
  TracedPacket to_sun[BUNDLE];
  MirroredPoint points[BUNDLE];
  for (int i = 0; i < BUNDLE; ++i) {
    const Hit* hit = &packets[i].hit;
    seen[i].there = asked[i] & lane_mask(hit->triangle != NO_TRIANGLE);
    points[i].dark = points[i].by_sun = lane3(zero, zero, zero);
    Ray ray = packets[i].ray;
    ray.t_max = (lane_float)-1.0f;
    if (lane_any(seen[i].there)) {
      const RayCone cone = eye_cone(&task->frame);
      HitTriangle triangle = load_hit_triangle(&world->grid, meshes, hit);
      load_texture_coordinates(scene, meshes, hit, &triangle);
      const lane_float distance = lane_select(seen[i].there, hit->t, zero);
      const lane_float across = cone_across(&cone, work[i].hit.t + distance);
      const SurfacePoint point = surface_point(scene, &triangle, &packets[i].ray, hit, across);
      const Surface surface = surface_at(view, &point);
      points[i] = mirrored_point(view, &surface);
      const ShadowPoint from = shadow_point_of(&triangle, hit);
      ray = shadow_ray(&from, hit, work[i].to_sun, (lane_float)INFINITY);
      const Lane3 sun = points[i].by_sun;
      const lane_int lit = seen[i].there & lane_mask(sun.x + sun.y + sun.z > 0.0f);
      ray.t_max = lane_select(lit, ray.t_max, (lane_float)-1.0f);
    }
    start_packet(to_sun + i, &ray);
  }
  if (casts_shadows(scene, LIGHT_SUN)) trace_bundle(world, to_sun, TRACE_ANY_FROM_ABOVE);
  for (int i = 0; i < BUNDLE; ++i) {
    if (!lane_any(seen[i].there)) continue;
    const lane_int dark = lane_mask(to_sun[i].hit.triangle != NO_TRIANGLE);
    const Lane3 sun = select3(dark, lane3(zero, zero, zero), points[i].by_sun);
    const lane_float distance = lane_select(seen[i].there, packets[i].hit.t, zero);
    Ray way = packets[i].ray;
    way.origin = place_of(scene, way.origin);
    seen[i].radiance =
        through_air(view, add3(points[i].dark, sun), &way, distance, (lane_float)0.5f);
  }
}

/* Writes what water and models mirror at the hits of a tile into the words of the lights that
 * arrive there. Every BUNDLE-th work-item traces BUNDLE blocks together. */
__kernel void look_into_mirrors(const AeroLaunch launch, __global const AeroScene* scene,
                                __global const uint* texels, __global const AeroBvhNode* nodes,
                                __global const AeroTriangle* triangles,
                                __global const AeroInstance* instances, __global const float* grid,
                                __global const AeroFace* faces, __global const AeroVertex* vertices,
                                __global const AeroChartWord* cloud_chart, __global const Hit* hits,
                                __global lane_uint* visible) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u || first >= launch.tile.block_count) return;
  const uint count = min((uint)BUNDLE, launch.tile.block_count - first);
  const AeroLaunch task = launch;
  const World world = make_world(nodes, triangles, instances, grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const SceneView view = scene_view(scene, 0, cloud_chart, texels);
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
