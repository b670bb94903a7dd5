/* Step 3 uses a tree of boxes in place of a loop over all triangles. This file comes after
 * rays.clh and traverse_tree.clh. */

__kernel void trace_all(Camera camera, __global const Triangle* triangles, uint count,
                        __global Hit* hits) {
  const int x = (int)get_global_id(0), y = (int)get_global_id(1);
  const int width = (int)get_global_size(0), height = (int)get_global_size(1);
  const Ray ray = camera_ray(&camera, (float)x + 0.5f, (float)y + 0.5f, width, height);
  Hit hit = no_hit();
  for (uint i = 0; i < count; ++i) {
    const Triangle triangle = triangles[i];
    hit_watertight(&triangle, &ray, i, &hit);
  }
  hits[y * width + x] = hit;
}

__kernel void trace_tree(Camera camera, __global const Node* nodes,
                         __global const Triangle* triangles, __global Hit* hits,
                         __global Work* works) {
  const int x = (int)get_global_id(0), y = (int)get_global_id(1);
  const int width = (int)get_global_size(0), height = (int)get_global_size(1);
  const Ray ray = camera_ray(&camera, (float)x + 0.5f, (float)y + 0.5f, width, height);
  Work work = {0, 0};
  hits[y * width + x] = traverse_tree(nodes, triangles, &ray, &work);
  works[y * width + x] = work;
}
