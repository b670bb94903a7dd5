/* Step 1 traces one ray for each pixel and intersects it with one triangle by determinants.
 *
 * The ray is P(t) = O + t D. A point of the triangle is A + u (B - A) + v (C - A), where u and v
 * are not negative and u + v is at most 1. The ray hits the triangle where both are the same
 * point:
 *
 *     t (-D) + u (B - A) + v (C - A) = O - A
 *
 * These are three equations, one for x, y and z, with three unknowns. Cramer's rule solves them:
 * each unknown is a quotient of two determinants. The denominator is the determinant of the
 * matrix whose columns are -D, B - A and C - A. In the numerator, the column of the unknown is
 * replaced by O - A. */

typedef struct {
  float v0[3], v1[3], v2[3];
} Triangle;

typedef struct {
  float eye[3], right[3], up[3], forward[3];
} Camera;

float3 vector(const float* v) {
  return (float3)(v[0], v[1], v[2]);
}

/* Returns the determinant of the matrix with the columns a, b and c. */
float determinant(float3 a, float3 b, float3 c) {
  return dot(a, cross(b, c));
}

/* Computes t, u and v. Returns 0 if the ray misses the triangle or begins behind it. */
int hit_triangle(float3 origin, float3 direction, Triangle triangle, float* t, float* u, float* v) {
  const float3 a = vector(triangle.v0);
  const float3 edge_b = vector(triangle.v1) - a;
  const float3 edge_c = vector(triangle.v2) - a;
  const float3 from_a = origin - a;

  const float all = determinant(-direction, edge_b, edge_c);
  if (all == 0.0f) return 0; /* the ray is parallel to the triangle */
  *t = determinant(from_a, edge_b, edge_c) / all;
  *u = determinant(-direction, from_a, edge_c) / all;
  *v = determinant(-direction, edge_b, from_a) / all;
  return *t >= 0.0f && *u >= 0.0f && *v >= 0.0f && *u + *v <= 1.0f;
}

/* Draws the picture. One work-item is one pixel. */
__kernel void draw_triangle(Camera camera, Triangle triangle, __global uchar* rgb) {
  const int x = (int)get_global_id(0), y = (int)get_global_id(1);
  const int width = (int)get_global_size(0), height = (int)get_global_size(1);

  /* The middle of the pixel lies between -1 and 1 in both directions. y points up, rows go down. */
  const float right = 2.0f * ((float)x + 0.5f) / (float)width - 1.0f;
  const float up = 1.0f - 2.0f * ((float)y + 0.5f) / (float)height;
  const float3 direction =
      vector(camera.forward) + right * vector(camera.right) + up * vector(camera.up);

  float t = 0.0f, u = 0.0f, v = 0.0f;
  float3 color = (float3)(0.15f, 0.2f, 0.3f);
  if (hit_triangle(vector(camera.eye), direction, triangle, &t, &u, &v)) {
    color = (float3)(1.0f - u - v, u, v); /* weights of the three corners */
  }
  const int pixel = 3 * (y * width + x);
  rgb[pixel] = convert_uchar_sat_rte(255.0f * color.x);
  rgb[pixel + 1] = convert_uchar_sat_rte(255.0f * color.y);
  rgb[pixel + 2] = convert_uchar_sat_rte(255.0f * color.z);
}
