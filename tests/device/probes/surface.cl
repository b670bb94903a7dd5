#include "geometry/hit_triangle.clh"
#include "probe.clh"

inline Hit load_hit(__global const float* tuv, __global const uint* slots) {
  Hit hit;
  hit.t = LOAD(tuv);
  hit.u = LOAD(tuv + PLANE);
  hit.v = LOAD(tuv + 2u * PLANE);
  hit.triangle = LOAD(slots);
  hit.instance = LOAD(slots + PLANE);
  return hit;
}

/* Stores the position, normal and colour at each hit, the normal of the plane, then the object and
 * the material. */
__kernel void probe_interpolation(__global const AeroInstance* instances,
                                  __global const float* grid, __global const AeroFace* faces,
                                  __global const AeroVertex* vertices, __global const float* tuv,
                                  __global const uint* slots, __global float* attributes,
                                  __global float* planes, __global uint* owners) {
  const Hit hit = load_hit(tuv, slots);
  const HeightGrid ground = height_grid(grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const HitTriangle triangle = load_hit_triangle(&ground, &meshes, &hit);
  store3_planes(interpolate3(triangle.corners, &hit), attributes);
  store3_planes(interpolate3(triangle.normals, &hit), attributes + 3u * PLANE);
  store3_planes(interpolate3(triangle.colors, &hit), attributes + 6u * PLANE);
  store3_planes(plane_normal(triangle.corners), planes);
  STORE(triangle.object, owners);
  STORE(triangle.material, owners + PLANE);
}

__kernel void probe_lift(__global const AeroInstance* instances, __global const float* grid,
                         __global const AeroFace* faces, __global const AeroVertex* vertices,
                         __global const float* tuv, __global const uint* slots,
                         __global const float* sides, __global float* lifted) {
  const Hit hit = load_hit(tuv, slots);
  const HeightGrid ground = height_grid(grid);
  const MeshArrays meshes = mesh_arrays(faces, vertices, instances);
  const HitTriangle triangle = load_hit_triangle(&ground, &meshes, &hit);
  const Lane3 position = interpolate3(triangle.corners, &hit);
  store3_planes(lift_from_facets(position, triangle.corners, triangle.normals, LOAD(sides), &hit),
                lifted);
}
