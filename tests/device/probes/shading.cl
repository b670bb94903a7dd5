#include "atmosphere/cloud_march.clh"
#include "integrator/local.clh"
#include "probe.clh"
#include "surface_of.clh"

__kernel void probe_phong(__global const AeroScene* scene, __global const AeroSkyCell* sky_table,
                          __global const AeroChartWord* cloud_chart,
                          __global const float* coefficients, __global const float* positions,
                          __global const float* normals, __global const float* viewers,
                          __global const uint* visible, __global float* radiance) {
  const SceneView view = scene_view(scene, sky_table, cloud_chart, 0);
  Surface surface = surface_of(coefficients, load3(normals), load3(viewers));
  surface.point.position = load3(positions);
  const AmbientFound around = all_free();
  store3_planes(local_radiance(&view, &surface, LOAD(visible), &around), radiance);
}

__kernel void probe_sky(__global const AeroScene* scene, __global const AeroSkyCell* sky_table,
                        __global const AeroChartWord* cloud_chart, __global const float* origins,
                        __global const float* directions, __global float* light,
                        __global float* radiance) {
  const SceneView view = scene_view(scene, sky_table, cloud_chart, 0);
  Ray ray;
  ray.origin = load3(origins);
  ray.direction = load3(directions);
  ray.t_max = (lane_float)INFINITY;
  store3_planes(sky_light(&view, ray.direction), light);
  store3_planes(sky_radiance(&view, &ray, (lane_float)0.5f), radiance);
}

__kernel void probe_air(__global const AeroScene* scene, __global const float* origins,
                        __global const float* directions, __global const float* distances,
                        __global const float* radiance, __global float* arriving) {
  const SceneView view = scene_view(scene, 0, 0, 0);
  Ray ray;
  ray.origin = load3(origins);
  ray.direction = load3(directions);
  ray.t_max = (lane_float)INFINITY;
  store3_planes(through_air(&view, load3(radiance), &ray, LOAD(distances), (lane_float)0.5f),
                arriving);
}

__kernel void probe_lit_in_air(__global const AeroScene* scene, __global const uint* texels,
                               __global const float* positions, __global float* lit) {
  const SceneView view = scene_view(scene, 0, 0, texels);
  const AirSun sun = sun_in_air(&view, load3(positions));
  STORE(lit_between(&sun, &sun), lit);
}

__kernel void probe_shaded_air(__global const AeroScene* scene, __global const uint* texels,
                               __global const float* origins, __global const float* directions,
                               __global const float* distances, __global const float* shifts,
                               __global float* added, __global float* shaded) {
  const SceneView view = scene_view(scene, 0, 0, texels);
  Ray ray;
  ray.origin = load3(origins);
  ray.direction = load3(directions);
  ray.t_max = (lane_float)INFINITY;
  const AirLight light = air_light(&view, &ray, LOAD(distances), LOAD(shifts));
  store3_planes(light.add, added);
  store3_planes(light.shaded, shaded);
}

/* Stores what shadows in the air take from a white sky, for the middle shift. */
__kernel void probe_sky_in_shadow(__global const AeroScene* scene, __global const uint* texels,
                                  __global const float* origins, __global const float* directions,
                                  __global float* lost) {
  const SceneView view = scene_view(scene, 0, 0, texels);
  Ray ray;
  ray.origin = load3(origins);
  ray.direction = load3(directions);
  ray.t_max = (lane_float)INFINITY;
  const Lane3 white = lane3((lane_float)1.0f, (lane_float)1.0f, (lane_float)1.0f);
  store3_planes(sub3(white, with_shadows(&view, white, &ray, (lane_float)0.5f)), lost);
}

__kernel void probe_sun(__global const AeroScene* scene, __global const float* heights,
                        __global const float* normals, __global float* sun,
                        __global float* ambient) {
  store3_planes(sun_at(scene, LOAD(heights)), sun);
  store3_planes(ambient_light(scene, load3(normals)), ambient);
}

__kernel void probe_cloud_shadow(__global const AeroScene* scene,
                                 __global const AeroSkyCell* sky_table,
                                 __global const AeroChartWord* cloud_chart,
                                 __global const float* positions, __global const float* footprints,
                                 __global float* share) {
  const SceneView view = scene_view(scene, sky_table, cloud_chart, 0);
  STORE(cumulus_shadow(&view, load3(positions), LOAD(footprints)), share);
}

__kernel void probe_clouds(__global const AeroScene* scene, __global const AeroSkyCell* sky_table,
                           __global const AeroChartWord* cloud_chart, __global const float* origins,
                           __global const float* directions, __global const float* distances,
                           const float behind, const float shift, __global float* arriving) {
  const SceneView view = scene_view(scene, sky_table, cloud_chart, 0);
  Ray ray;
  ray.origin = load3(origins);
  ray.direction = load3(directions);
  ray.t_max = (lane_float)INFINITY;
  const Lane3 light = lane3((lane_float)behind, (lane_float)behind, (lane_float)behind);
  store3_planes(behind_clouds(&view, light, &ray, LOAD(distances), 0.05f, (lane_float)shift),
                arriving);
}

__kernel void probe_cloud_density(__global const AeroScene* scene,
                                  __global const AeroSkyCell* sky_table,
                                  __global const AeroChartWord* cloud_chart,
                                  __global const float* positions, __global const float* footprints,
                                  __global float* density) {
  const SceneView view = scene_view(scene, sky_table, cloud_chart, 0);
  const Lane3 p = load3(positions);
  STORE(cumulus_density(&view, p, p.y, LOAD(footprints)), density);
}

/* Stores the same light as probe_clouds for rays to the sky, computed by small, even steps that are
 * lit one by one, after a first march that finds the depth of all of them. */
__kernel void probe_clouds_finely(__global const AeroScene* scene,
                                  __global const AeroSkyCell* sky_table,
                                  __global const AeroChartWord* cloud_chart,
                                  __global const float* origins, __global const float* directions,
                                  const float step, __global float* arriving) {
  const SceneView view = scene_view(scene, sky_table, cloud_chart, 0);
  __global const AeroCumulus* clouds = &scene->sky.cumulus;
  Ray ray;
  ray.origin = load3(origins);
  ray.direction = load3(directions);
  ray.t_max = (lane_float)INFINITY;
  const lane_float towards = dot3(ray.direction, lane3_from(scene->sky.sun_direction));
  lane_float seen = (lane_float)0.0f;
  Lane3 light = lane3(seen, seen, seen);
  CloudMarch march;
  for (int lit = 0; lit < 2; ++lit) {
    march = start_march(clouds, &ray, ray.t_max, (lane_float)0.5f);
    for (int i = 0; i < 1000000; ++i) {
      const lane_int on = lane_mask(march.t < march.end) & lane_mask(march.through > 1e-3f);
      if (!lane_any(on)) break;
      Lane3 p = madd3(ray.origin, ray.direction, march.t);
      p.y = height_on_way(&ray, march.t);
      const lane_float footprint = 0.05f * march.t;
      const lane_float found = cumulus_density(&view, p, p.y, footprint);
      const lane_float density = lane_select(on, found, (lane_float)0.0f);
      const lane_float left = march.through * exp(-clouds->extinction * density * step);
      const lane_float hidden = march.through - left;
      if (lit && lane_any(lane_mask(hidden > 0.0f))) {
        const lane_float height = (p.y - clouds->base) / clouds->thickness;
        const Lane3 source =
            cloud_source(&view, p, height, towards, footprint, (lane_float)0.5f, seen, (lane_int)0);
        light = madd3(light, source, hidden);
        march.way = lane_fma(hidden, march.t, march.way);
      }
      march.through = left;
      march.t += step;
    }
    seen = -log(march.through);
  }
  const lane_float inverse = 1.0f / lane_max(1.0f - march.through, (lane_float)1e-6f);
  const Lane3 arrives =
      through_air(&view, scale3(light, inverse), &ray, march.way * inverse, (lane_float)0.5f);
  const Lane3 white = lane3((lane_float)1.0f, (lane_float)1.0f, (lane_float)1.0f);
  store3_planes(mix3(white, arrives, 1.0f - march.through), arriving);
}

/* Computes the cover of a line whose half width is 2 cm. */
__kernel void probe_line(__global const float* distances, __global const float* pixels,
                         __global float* covers) {
  STORE(line_cover(LOAD(distances), 0.02f, LOAD(pixels)), covers);
}

/* Sews envelope whose gores and panels are 1.5 m and 1 m wide. Stores the shares of tape and seam,
 * and the slope across the gores. */
__kernel void probe_sew(__global const float* u, __global const float* v, const float pixel,
                        __global float* sewn) {
  const lane_float width = (lane_float)pixel;
  SurfaceUv uv;
  uv.u = LOAD(u);
  uv.v = LOAD(v);
  const Sewing sewing = sew_envelope(&uv, (lane_float)1.5f, (lane_float)1.0f, width, width, width);
  store3_planes(lane3(sewing.tape, sewing.seam, sewing.slope_u), sewn);
}

__kernel void probe_flame(__global const AeroScene* scene, __global const float* positions,
                          __global const float* normals, __global float* light) {
  store3_planes(flame_on(scene, (lane_uint)0u, load3(positions), load3(normals)), light);
}

/* Computes the glow in the dark of white cloth that transmits the share `through[0]` of the light
 * and reflects the rest. */
__kernel void probe_cloth(__global const AeroScene* scene, __global const float* through,
                          __global const float* normals, __global const uint* inside,
                          __global float* glow) {
  const lane_float one = (lane_float)1.0f, none = (lane_float)0.0f;
  Surface surface = blank_surface();
  surface.point.normal = surface.point.to_viewer = surface.material.normal = load3(normals);
  surface.material.albedo = lane3(one, one, one);
  surface.material.ambient = surface.material.diffuse = 1.0f - (lane_float)through[0];
  surface.material.translucency = (lane_float)through[0];
  const Lane3 sun = sun_at(scene, height_of(scene, surface.point.position));
  const lane_int within = lane_as_int(LOAD(inside));
  store3_planes(cloth_glow(scene, &surface, within, sun, none), glow);
}

__kernel void probe_mirrored(__global const float* radiance, __global const float* numbers,
                             __global float* kept) {
  Mirrored seen;
  seen.there = (lane_int)-1;
  seen.radiance = load3(radiance);
  const Mirrored read = mirrored_of(mirrored_word(&seen, LOAD(numbers)));
  store3_planes(read.radiance, kept);
}
