#ifndef AEROSTAT_SHARED_BVH_NODE_H
#define AEROSTAT_SHARED_BVH_NODE_H

#include "layout.h"

/* Children of a node of the wide BVH; also the width of the interval tests. */
#define AERO_BVH_WIDTH 8

/* Entries of the kernels' traversal stack. The builder measures what a tree needs and refuses more.
 */
#define AERO_BVH_STACK 160

/* A child reference: an inner node's index, or with the top bit set a leaf: bits 27..30 hold the
 * number of triangles less one, bits 0..26 the index of the first. An empty slot is
 * AERO_BVH_EMPTY, which a traversal must pass over; its bounds are lo = +inf, hi = -inf. */
#define AERO_BVH_LEAF 0x80000000u
#define AERO_BVH_COUNT_SHIFT 27
#define AERO_BVH_COUNT_MASK 0xfu
#define AERO_BVH_FIRST_MASK 0x07ffffffu
#define AERO_BVH_EMPTY 0xffffffffu
#define AERO_BVH_MAX_LEAF 8

/* A leaf with this bit, too, is a patch of eight cells of the height grid: bits 28 and 29 hold its
 * shape, bits 14..27 and 0..13 the row and the column of its first cell. What a node would hold,
 * the boxes of the cells, is worked out from the heights. */
#define AERO_BVH_PATCH 0x40000000u
#define AERO_PATCH_SHAPE_SHIFT 28
#define AERO_PATCH_SHAPE_MASK 0x3u
#define AERO_PATCH_ROW_SHIFT 14
#define AERO_PATCH_CELL_MASK 0x3fffu
/* Cells of a patch are numbered row by row. */
#define AERO_PATCH_WIDE 0u /* 4 along x, 2 along z */
#define AERO_PATCH_DEEP 1u /* 2 along x, 4 along z */
/* No patch but an instance, whose number stands in bits 0..27. */
#define AERO_PATCH_INSTANCE 2u
#define AERO_INSTANCE_MASK 0x0fffffffu

/* What is known of the slopes of the ground below a child: four bytes, from the lowest on the least
 * and the greatest rise along x for each metre, and the same along z, each of which stands for
 * (byte - AERO_SLOPE_ZERO) / AERO_SLOPE_STEPS. */
#define AERO_SLOPE_UNKNOWN 0xffffffffu
#define AERO_SLOPE_ZERO 128
#define AERO_SLOPE_STEPS 16

/* Bounds of up to eight children, one array per plane: lo[axis][child]. Node 0 is the root. On the
 * host nodes are aligned to cache lines, for a device that reads them there. */
typedef struct AERO_ALIGNED_ON_HOST(64) AeroBvhNode {
  aero_float lo[3][AERO_BVH_WIDTH];
  aero_float hi[3][AERO_BVH_WIDTH];
  aero_uint child[AERO_BVH_WIDTH];
  aero_uint slope[AERO_BVH_WIDTH];
} AeroBvhNode;

AERO_ASSERT_LAYOUT(AeroBvhNode, 256);

#endif
