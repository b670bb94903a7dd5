#include "bvh/leaf.clh"
#include "bvh/stack.clh"
#include "probe.clh"

/* Each work-item pushes the children 1 to 8 of a node, at the given distances, onto a stack that
 * holds the reference 0. Stores the references of the stack from the bottom to the top. */
__kernel void probe_push(__global const float* enters, __global uint* references) {
  const uint item = (uint)get_global_id(0);
  TraceStack stack;
  start_stack(&stack, 0u, 0u);
  const int first = stack.size;
  for (uint i = 0u; i < AERO_BVH_WIDTH; ++i) {
    push_child(&stack, first, i + 1u, enters[item * AERO_BVH_WIDTH + i], i + 1u);
  }
  for (int i = 0; i < stack.size; ++i) {
    references[item * (AERO_BVH_WIDTH + 1u) + (uint)i] = stack.reference[i];
  }
}

/* Stores the columns and the rows of the cells of a patch, in the order in which rays visit the
 * cells. The number of the work-item chooses the rays: bit 0 is set for rays with a negative x
 * direction, and bit 1 for rays with a negative z direction. Bit 2 is the shape of the patch. */
__kernel void probe_order(__global uint* columns, __global uint* rows) {
  const uint item = (uint)get_global_id(0);
  Frustum frustum;
  frustum.near_at[0] = (item & 1u) != 0u ? 3u : 0u;
  frustum.far_at[0] = (item & 1u) != 0u ? 0u : 3u;
  frustum.near_at[2] = (item & 2u) != 0u ? 5u : 2u;
  frustum.far_at[2] = (item & 2u) != 0u ? 2u : 5u;
  Patch patch;
  patch.i = patch.j = 0u;
  patch.shape = item >> 2;
  const uint flip = front_to_back(&patch, &frustum);
  for (uint turn = 0u; turn < AERO_BVH_WIDTH; ++turn) {
    columns[item * AERO_BVH_WIDTH + turn] = patch_column(&patch, turn ^ flip);
    rows[item * AERO_BVH_WIDTH + turn] = patch_row(&patch, turn ^ flip);
  }
}

/* Work-item i stores the bits of i & 255 in the order of the flip i >> 8. */
__kernel void probe_flip(__global uint* bits) {
  const uint item = (uint)get_global_id(0);
  bits[item] = flip_bits8(item & 255u, item >> 8);
}
