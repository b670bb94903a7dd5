#ifndef AEROSTAT_SHARED_TRACE_TRIANGLE_H
#define AEROSTAT_SHARED_TRACE_TRIANGLE_H

#include "layout.h"

/* A triangle as an intersection test reads it, in metres and world space. Triangles are in the
 * order of the tree's leaves. */
typedef struct AeroTriangle {
  aero_float v0[3];
  aero_float v1[3];
  aero_float v2[3];
} AeroTriangle;

AERO_ASSERT_LAYOUT(AeroTriangle, 36);

/* What a picture says of who was hit: the ids of objects. Others are the host's alone. */
#define AERO_OBJECT_SKY 0
#define AERO_OBJECT_TERRAIN 1 /* the height grid */

/* What shading reads, in the order of the tree's leaves: the indices of the three vertices, the id
 * of the object and the number of the material in AeroScene::materials. */
typedef struct AeroFace {
  aero_uint vertex[3];
  aero_uint object;
  aero_uint material;
} AeroFace;

AERO_ASSERT_LAYOUT(AeroFace, 20);

/* Attributes of a vertex: unit normal, linear albedo (or the water's depth in color[0]) and texture
 * coordinates, for materials that are finer than triangles. */
typedef struct AeroVertex {
  aero_float position[3];
  aero_float normal[3];
  aero_float color[3];
  aero_float uv[2];
} AeroVertex;

AERO_ASSERT_LAYOUT(AeroVertex, 44);

#endif
