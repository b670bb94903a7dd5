#ifndef AEROSTAT_RULES_HEIGHT_CELL_H
#define AEROSTAT_RULES_HEIGHT_CELL_H

#include "rules/rules.h"

/* How a cell of the height grid (height_grid.h) becomes triangles. Its corners are A (i, j),
 * B (i + 1, j), C (i, j + 1) and D (i + 1, j + 1). */

AERO_RULES_BEGIN

/* Gives whether a cell with these heights of its corners is split along AD, and not along BC: a
 * cell is split along the diagonal that is less steep, and along AD if both are equally steep. The
 * heights may be vectors of any width. */
#define CELL_ALONG_AD(a, b, c, d) (fabs((a) - (d)) <= fabs((b) - (c)))

AERO_RULE lane_int cell_along_ad(lane_float a, lane_float b, lane_float c, lane_float d) {
  return lane_mask(CELL_ALONG_AD(a, b, c, d));
}

/* Writes what belongs to A, B, C and D to to[0] to to[3], in the order in which the triangles of
 * the cell count its corners. Triangle 0 has the corners 0, 1 and 2, and triangle 1 has 0, 2 and 3,
 * counter-clockwise seen from above; the diagonal runs from 0 to 2. So the triangles are ACD and
 * ADB along AD, and BAC and BCD along BC. select(mask, x, y) gives x where the mask is set, else y.
 */
#define CELL_CORNERS(select, along_ad, a, b, c, d, to) \
  do {                                                 \
    (to)[0] = select(along_ad, a, b);                  \
    (to)[1] = select(along_ad, c, a);                  \
    (to)[2] = select(along_ad, d, c);                  \
    (to)[3] = select(along_ad, b, d);                  \
  } while (0)

/* Return x and z of a packed normal over |x| + |y| + |z|. */
AERO_RULE lane_float packed_normal_x(lane_uint packed) {
  return lane_from_int(lane_as_int(packed << 16u) >> 16) * (1.0f / 32767.0f);
}
AERO_RULE lane_float packed_normal_z(lane_uint packed) {
  return lane_from_int(lane_as_int(packed) >> 16) * (1.0f / 32767.0f);
}

AERO_RULES_END

#endif
