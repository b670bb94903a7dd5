#ifndef AEROSTAT_SHARED_INSTANCE_H
#define AEROSTAT_SHARED_INSTANCE_H

#include "layout.h"

/* A model that stands in the world, turned, scaled and moved. A point v of the model lies at
 * position + axes v, where the columns of axes are perpendicular and equally long. */
typedef struct AeroInstance {
  aero_float axes[3][3]; /* indexed by [column][component] */
  aero_float position[3];
  aero_float scale;   /* length of a column */
  aero_float tint[3]; /* multiplies the colours of the model's vertices */
  aero_uint root;     /* root node of the model's tree */
  aero_float lo[3];   /* box in the world, as the tree holds it */
  aero_float hi[3];
  aero_uint is_plant; /* 1: a plant or stone, whose own shade is known beforehand if it is small */
} AeroInstance;

AERO_ASSERT_LAYOUT(AeroInstance, 96);

#endif
