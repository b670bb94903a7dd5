#include "material/texture.clh"
#include "probe.clh"

/* Stores colours and opacities of the texture at word `places[0]`, which covers a square of 1 m, at
 * points of a plane: u, v and the footprint in metres. `places[1]` is 1 for colours in sRGB. */
__kernel void probe_texture(__global const uint* texels, __global const uint* places,
                            __global const float* points, __global float* found) {
  const Lane3 point = load3(points);
  const lane_float zero = (lane_float)0.0f, one = (lane_float)1.0f;
  SurfaceUv uv;
  uv.u = point.x;
  uv.v = point.y;
  uv.dp_du = lane3(one, zero, zero);
  uv.dp_dv = lane3(zero, zero, one);
  const lane_uint texture = (lane_uint)places[0];
  const TextureColor seen = places[1] != 0u ? texture_at(texels, texture, &uv, point.z, 1)
                                            : texture_at(texels, texture, &uv, point.z, 0);
  store3_planes(seen.color, found);
  STORE(seen.opacity, found + 3u * PLANE);
}
