#include "probe.clh"
#include "surface.clh"

inline Hit load_hit(__global const float* tuv, __global const uint* slots) {
  Hit hit;
  hit.t = LOAD(tuv);
  hit.u = LOAD(tuv + PLANE);
  hit.v = LOAD(tuv + 2u * PLANE);
  hit.triangle = LOAD(slots);
  return hit;
}

/* Three vertex numbers and the object of each hit, as planes. */
__kernel void probe_faces(__global const AeroFace* faces, __global const uint* slots,
                          __global uint* loaded) {
  const Face face = load_face(faces, LOAD(slots));
  for (uint i = 0u; i < 3u; ++i) STORE(face.vertex[i], loaded + i * PLANE);
  STORE(face.object, loaded + 3u * PLANE);
}

/* Position, normal and colour at each hit, and the plane's normal. */
__kernel void probe_interpolation(__global const AeroFace* faces,
                                  __global const AeroVertex* vertices, __global const float* tuv,
                                  __global const uint* slots, __global float* attributes,
                                  __global float* planes) {
  const Hit hit = load_hit(tuv, slots);
  const Face face = load_face(faces, hit.triangle);
  Lane3 corners[3];
  load_corners(vertices, &face, normal, corners);
  store3_planes(interpolate3(corners, &hit), attributes + 3u * PLANE);
  load_corners(vertices, &face, color, corners);
  store3_planes(interpolate3(corners, &hit), attributes + 6u * PLANE);
  load_corners(vertices, &face, position, corners);
  store3_planes(interpolate3(corners, &hit), attributes);
  store3_planes(plane_normal(corners), planes);
}

__kernel void probe_lift(__global const AeroFace* faces, __global const AeroVertex* vertices,
                         __global const float* tuv, __global const uint* slots,
                         __global const float* sides, __global float* lifted) {
  const Hit hit = load_hit(tuv, slots);
  const Face face = load_face(faces, hit.triangle);
  Lane3 corners[3], normals[3];
  load_corners(vertices, &face, position, corners);
  load_corners(vertices, &face, normal, normals);
  const Lane3 position = interpolate3(corners, &hit);
  store3_planes(lift_from_facets(position, corners, normals, LOAD(sides), &hit), lifted);
}
