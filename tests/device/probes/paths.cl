#include "integrator/path_ray.clh"
#include "light/lights.clh"
#include "noise/noise.clh"
#include "probe.clh"

/* Rays that come from nowhere, as path rays. */
__kernel void probe_make_paths(__global const float* origins, __global const float* directions,
                               __global const float* widths, __global const float* spreads,
                               __global const uint* pixels, __global PathRay* paths) {
  const lane_float one = (lane_float)1.0f;
  PathRay path;
  path.ray.origin = load3(origins);
  path.ray.direction = load3(directions);
  path.ray.t_max = (lane_float)INFINITY;
  path.cone.width = LOAD(widths);
  path.cone.spread = LOAD(spreads);
  path.throughput = lane3(one, one, one);
  path.pixel = LOAD(pixels);
  paths[get_global_id(0)] = path;
}

/* Numbers that are the same for a pixel whatever packet it is in. */
inline SampleNumbers numbers_of(lane_uint pixel, uint bounce) {
  const lane_uint hash = hash_column(bounce, lane_as_int(pixel));
  SampleNumbers at;
  at.u = unit_interval(hash_row(hash, (lane_int)1));
  at.v = unit_interval(hash_row(hash, (lane_int)2));
  at.w = unit_interval(hash_row(hash, (lane_int)3));
  return at;
}

inline void add_radiance(__global float* radiance, const PathRay* path, lane_int lanes,
                         Lane3 value) {
  LaneArray parts[3];
  LaneArrayUint pixel;
  parts[0].lanes = lane_select(lanes, value.x, (lane_float)0.0f);
  parts[1].lanes = lane_select(lanes, value.y, (lane_float)0.0f);
  parts[2].lanes = lane_select(lanes, value.z, (lane_float)0.0f);
  pixel.lanes = path->pixel;
  for (int i = 0; i < LANES; ++i) {
    for (int c = 0; c < 3; ++c) radiance[3u * pixel.at[i] + (uint)c] += parts[c].at[i];
  }
}

/* Follows all path rays for one bounce: a path tracer whose only light is the sky. */
__kernel void probe_follow_paths(
    __global const AeroScene* scene, __global const AeroSkyCell* sky_table,
    __global const AeroChartWord* cloud_chart, __global const AeroBvhNode* nodes,
    __global const AeroTriangle* triangles, __global const AeroInstance* instances,
    __global const float* grid, __global const AeroFace* faces, __global const AeroVertex* vertices,
    const uint bounce, __global PathRay* paths, __global float* radiance) {
  const uint first = (uint)get_global_id(0);
  if (first % BUNDLE != 0u) return;
  const SceneView view = scene_view(scene, sky_table, cloud_chart, 0);
  const World world = make_world(nodes, triangles, instances, grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  PathRay bundle[BUNDLE];
  Hit hits[BUNDLE];
  for (uint i = 0u; i < BUNDLE; ++i) bundle[i] = paths[first + i];
  trace_paths(&world, bundle, hits);
  for (uint i = 0u; i < BUNDLE; ++i) {
    const PathRay* path = bundle + i;
    const lane_int on = lane_mask(path->ray.t_max >= 0.0f);
    const lane_int free = on & lane_mask(hits[i].triangle == NO_TRIANGLE);
    const Lane3 sky = mul3(path->throughput, sky_without_sun(&view, &path->ray));
    add_radiance(radiance, path, free, sky);
    const Surface surface = path_surface(&view, &world, &meshes, path, hits + i);
    const SampleNumbers at = numbers_of(path->pixel, bounce);
    const MaterialSample sample = sample_material(&surface, &at);
    paths[first + i] = scattered_path(path, &surface, hits + i, &sample);
  }
}
