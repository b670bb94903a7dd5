/* Step 2 traces several rays in one work-item.
 *
 * A CPU core computes with vectors: one instruction adds 8 numbers as fast as one. OpenCL C has
 * vector types for this. A float8 is eight floats, and a + b adds eight pairs. So a work-item can
 * trace eight rays, one in each lane of its vectors. The same text serves both cases: LANES is 1
 * or 8.
 *
 * Decisions are made in another way. Eight rays do not agree, so there is no `if` on a vector. A
 * comparison of vectors gives a mask, which is -1 (all bits set) in the lanes where it is true
 * and 0 in the others. select(a, b, mask) takes b where the mask is set. */

#if LANES == 8
typedef float8 lane_float;
typedef int8 lane_int;
#define LANE_INDEX ((lane_float)(0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f))
#define as_mask(comparison) (comparison)
int any_lane(lane_int mask) {
  return any(mask);
}
#else
typedef float lane_float;
typedef int lane_int;
#define LANE_INDEX 0.0f
#define as_mask(comparison) (-(comparison)) /* scalars give 1, not -1 */
int any_lane(lane_int mask) {
  return mask != 0;
}
#endif

/* Without this line, the compiler could round a * b + c once or twice as it likes, and the
 * results of one lane and of eight could differ. */
#pragma OPENCL FP_CONTRACT OFF

typedef struct {
  float v0[3], v1[3], v2[3];
} Triangle;

typedef struct {
  float eye[3], right[3], up[3], forward[3];
} Camera;

/* One vector of space in each lane. */
typedef struct {
  lane_float x, y, z;
} Lane3;

Lane3 lane3(lane_float x, lane_float y, lane_float z) {
  const Lane3 v = {x, y, z};
  return v;
}
Lane3 same3(const float* v) { /* the same vector in all lanes */
  return lane3((lane_float)v[0], (lane_float)v[1], (lane_float)v[2]);
}
Lane3 sub3(Lane3 a, Lane3 b) {
  return lane3(a.x - b.x, a.y - b.y, a.z - b.z);
}
Lane3 cross3(Lane3 a, Lane3 b) {
  return lane3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
lane_float dot3(Lane3 a, Lane3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* Tests a triangle in all lanes, as step 1 does in one. Returns the mask of the lanes that hit it
 * nearer than *t, and replaces t, u and v in these lanes. */
lane_int hit_triangle(Lane3 origin, Lane3 direction, const Triangle* triangle, lane_float* t,
                      lane_float* u, lane_float* v) {
  const Lane3 a = same3(triangle->v0);
  const Lane3 edge_b = sub3(same3(triangle->v1), a);
  const Lane3 edge_c = sub3(same3(triangle->v2), a);
  const Lane3 from_a = sub3(origin, a);
  const Lane3 normal = cross3(edge_b, edge_c);
  const Lane3 aside = cross3(direction, from_a);
  const lane_float all = -dot3(direction, normal);
  const lane_float new_t = dot3(from_a, normal) / all;
  const lane_float new_u = -dot3(edge_c, aside) / all;
  const lane_float new_v = dot3(edge_b, aside) / all;
  /* A division by zero gives infinity or NaN here. For these, one of the comparisons is false. */
  const lane_int hit = as_mask(new_t >= 0.0f) & as_mask(new_t < *t) & as_mask(new_u >= 0.0f) &
                       as_mask(new_v >= 0.0f) & as_mask(new_u + new_v <= 1.0f);
  *t = select(*t, new_t, hit);
  *u = select(*u, new_u, hit);
  *v = select(*v, new_v, hit);
  return hit;
}

/* Traces LANES pixels of a row in each work-item. */
__kernel void trace_rows(Camera camera, __global const Triangle* triangles, int count, int width,
                         __global float* depths, __global uint* hits) {
  const int x = (int)get_global_id(0) * LANES, y = (int)get_global_id(1);
  const int height = (int)get_global_size(1);
  const lane_float right = 2.0f * ((float)x + LANE_INDEX + 0.5f) / (float)width - 1.0f;
  const float up = 1.0f - 2.0f * ((float)y + 0.5f) / (float)height;
  const Lane3 direction = lane3(camera.forward[0] + right * camera.right[0] + up * camera.up[0],
                                camera.forward[1] + right * camera.right[1] + up * camera.up[1],
                                camera.forward[2] + right * camera.right[2] + up * camera.up[2]);

  lane_float t = INFINITY, u = 0.0f, v = 0.0f;
  lane_int which = -1;
  for (int i = 0; i < count; ++i) {
    const Triangle triangle = triangles[i];
    const lane_int hit = hit_triangle(same3(camera.eye), direction, &triangle, &t, &u, &v);
    if (any_lane(hit)) which = select(which, (lane_int)i, hit);
  }
  const int pixel = y * width + x;
#if LANES == 8
  vstore8(t, 0, depths + pixel);
  vstore8(as_uint8(which), 0, hits + pixel);
#else
  depths[pixel] = t;
  hits[pixel] = as_uint(which);
#endif
}
