/* Step 5 lets 8 x 8 rays traverse the tree together. This file comes after rays.clh,
 * traverse_tree.clh and step3_tree.cl, whose kernel trace_tree serves for comparison.
 *
 * Neighbouring rays of a camera visit nearly the same nodes. Therefore a work-item takes 64 rays
 * and asks for each box only once whether any of these rays can meet it. Intervals give the
 * answer. All rays begin at the eye, and their directions lie between a smallest and a largest
 * one on each axis. */

#define SIDE 8
#define RAYS (SIDE * SIDE)

typedef struct {
  float3 origin;
  float3 least, most; /* bounds of 1 / direction over all rays */
  int3 useful;        /* axes whose directions all have the same sign */
} Frustum;

/* These functions return the smallest and the largest product of a number with a number from the
 * interval [least, most]. */
float smallest_product(float a, float least, float most) {
  return fmin(a * least, a * most);
}
float largest_product(float a, float least, float most) {
  return fmax(a * least, a * most);
}

/* Returns whether any ray of the frustum can meet the box nearer than t_max. It may return true
 * if no ray meets the box. It never returns false if a ray does, because rounding is always taken
 * to the safe side. */
int may_enter_box(const Node* node, const Frustum* frustum, float t_max) {
  float enter = 0.0f, leave = t_max;
  const float origin[3] = {frustum->origin.x, frustum->origin.y, frustum->origin.z};
  const float least[3] = {frustum->least.x, frustum->least.y, frustum->least.z};
  const float most[3] = {frustum->most.x, frustum->most.y, frustum->most.z};
  const int useful[3] = {frustum->useful.x, frustum->useful.y, frustum->useful.z};
  for (int axis = 0; axis < 3; ++axis) {
    if (!useful[axis]) continue;
    const float to_low = node->low[axis] - origin[axis], to_high = node->high[axis] - origin[axis];
    const float near_side = least[axis] > 0.0f ? to_low : to_high;
    const float far_side = least[axis] > 0.0f ? to_high : to_low;
    enter = fmax(enter, smallest_product(near_side, least[axis], most[axis]));
    leave = fmin(leave, largest_product(far_side, least[axis], most[axis]));
  }
  return enter <= leave * 1.0000005f;
}

Frustum frustum_of(const Ray* rays) {
  Frustum frustum = {rays[0].origin, rays[0].inverse, rays[0].inverse, (int3)(1)};
  for (int i = 1; i < RAYS; ++i) {
    frustum.least = fmin(frustum.least, rays[i].inverse);
    frustum.most = fmax(frustum.most, rays[i].inverse);
  }
  frustum.useful = (frustum.least > 0.0f) | (frustum.most < 0.0f);
  frustum.useful &= isfinite(frustum.least) & isfinite(frustum.most);
  return frustum;
}

float farthest(const Hit* hits) {
  float t = hits[0].t;
  for (int i = 1; i < RAYS; ++i) t = fmax(t, hits[i].t);
  return t;
}

/* Traces SIDE x SIDE pixels in each work-item. */
__kernel void trace_packets(Camera camera, __global const Node* nodes,
                            __global const Triangle* triangles, int width, int height,
                            __global Hit* hits, __global Work* works) {
  const int left = (int)get_global_id(0) * SIDE, top = (int)get_global_id(1) * SIDE;
  Ray rays[RAYS];
  Hit found[RAYS];
  for (int i = 0; i < RAYS; ++i) {
    rays[i] = camera_ray(&camera, (float)(left + i % SIDE) + 0.5f, (float)(top + i / SIDE) + 0.5f,
                         width, height);
    found[i] = no_hit();
  }
  const Frustum frustum = frustum_of(rays);

  Work work = {0, 0};
  uint stack[STACK_SIZE];
  int size = 0;
  float t_max = INFINITY;
  stack[size++] = 0;
  while (size > 0) {
    const Node node = nodes[stack[--size]];
    ++work.boxes;
    if (!may_enter_box(&node, &frustum, t_max)) continue;
    if (node.count == 0) {
      /* The child that lies farther along the middle ray goes on the stack first. */
      const Node a = nodes[node.first], b = nodes[node.first + 1];
      const float3 way = rays[RAYS / 2].direction;
      const float3 apart = vector(a.low) + vector(a.high) - vector(b.low) - vector(b.high);
      const uint first_is_farther = dot(apart, way) > 0.0f;
      stack[size++] = node.first + (first_is_farther ? 0 : 1);
      stack[size++] = node.first + (first_is_farther ? 1 : 0);
      continue;
    }
    for (uint k = node.first; k < node.first + node.count; ++k) {
      const Triangle triangle = triangles[k];
      for (int i = 0; i < RAYS; ++i) hit_watertight(&triangle, &rays[i], k, &found[i]);
    }
    work.triangles += node.count;
    t_max = farthest(found);
  }

  for (int i = 0; i < RAYS; ++i) hits[(top + i / SIDE) * width + left + i % SIDE] = found[i];
  works[get_global_id(1) * get_global_size(0) + get_global_id(0)] = work;
}
