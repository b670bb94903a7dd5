/* Step 4 traces rays from inside a closed mesh exactly at its edges. No ray may get out. This
 * file comes after rays.clh. */

/* Tests one ray in each work-item. Writes 1 for each of the two tests if the ray gets out by it,
 * else 0. The host adds these numbers. */
__kernel void shoot_at_edges(__global const Triangle* triangles, uint count,
                             __global const float* origins, __global const float* targets,
                             __global uint* out_by_edges, __global uint* out_by_woop) {
  const uint i = (uint)get_global_id(0);
  const float3 origin = vload3(i, origins);
  const Ray ray = make_ray(origin, vload3(i, targets) - origin);
  Hit by_edges = no_hit(), by_woop = no_hit();
  for (uint k = 0; k < count; ++k) {
    const Triangle triangle = triangles[k];
    hit_by_edges(&triangle, &ray, k, &by_edges);
    hit_watertight(&triangle, &ray, k, &by_woop);
  }
  out_by_edges[i] = by_edges.triangle == NO_TRIANGLE;
  out_by_woop[i] = by_woop.triangle == NO_TRIANGLE;
}
