#ifndef AEROSTAT_SHARED_BVH_NODE_H
#define AEROSTAT_SHARED_BVH_NODE_H

#include "layout.h"

/* Number of children of a node of the wide BVH, and the width of the interval tests. */
#define AERO_BVH_WIDTH 8

/* Number of entries of the kernels' traversal stack. The builder measures how many a tree needs and
 * refuses a tree that needs more. */
#define AERO_BVH_STACK 160

/* A child's reference is the index of an inner node, or a leaf if the top bit is set. Bits 27 to 30
 * of a leaf hold the number of triangles minus one, and bits 0 to 26 the index of the first
 * triangle. An empty slot is AERO_BVH_EMPTY, which a traversal must skip; its bounds are lo = +inf
 * and hi = -inf. */
#define AERO_BVH_LEAF 0x80000000u
#define AERO_BVH_COUNT_SHIFT 27
#define AERO_BVH_COUNT_MASK 0xfu
#define AERO_BVH_FIRST_MASK 0x07ffffffu
#define AERO_BVH_EMPTY 0xffffffffu
#define AERO_BVH_MAX_LEAF 8

/* A leaf that also has this bit is a patch of eight cells of the height grid. Bits 28 and 29 hold
 * its shape, bits 14 to 27 the row of its first cell, and bits 0 to 13 the column. The boxes of the
 * cells are not stored but worked out from the heights. */
#define AERO_BVH_PATCH 0x40000000u
#define AERO_PATCH_SHAPE_SHIFT 28
#define AERO_PATCH_SHAPE_MASK 0x3u
#define AERO_PATCH_ROW_SHIFT 14
#define AERO_PATCH_CELL_MASK 0x3fffu
/* Shapes of patches. The cells of a patch are numbered row by row. */
#define AERO_PATCH_WIDE 0u /* 4 cells along x, 2 along z */
#define AERO_PATCH_DEEP 1u /* 2 cells along x, 4 along z */
/* Shape of a leaf that is not a patch but an instance, whose number is in bits 0 to 27. */
#define AERO_PATCH_INSTANCE 2u
#define AERO_INSTANCE_MASK 0x0fffffffu

/* Bounds of the slopes of the ground below a child, in four bytes. From the lowest byte on, these
 * are the least and the greatest rise along x for each metre, and the least and the greatest rise
 * along z. A byte stands for the slope (byte - AERO_SLOPE_ZERO) / AERO_SLOPE_STEPS. */
#define AERO_SLOPE_UNKNOWN 0xffffffffu
#define AERO_SLOPE_ZERO 128
#define AERO_SLOPE_STEPS 16

/* A node with the bounds of up to eight children, one array for each plane: lo[axis][child]. Node 0
 * is the root. On the host, nodes are aligned to cache lines, because a device may read them
 * there. */
typedef struct AERO_ALIGNED_ON_HOST(64) AeroBvhNode {
  aero_float lo[3][AERO_BVH_WIDTH];
  aero_float hi[3][AERO_BVH_WIDTH];
  aero_uint child[AERO_BVH_WIDTH];
  aero_uint slope[AERO_BVH_WIDTH];
} AeroBvhNode;

AERO_ASSERT_LAYOUT(AeroBvhNode, 256);

#endif
