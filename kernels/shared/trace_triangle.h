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

/* What shading reads, in the same order: the three vertices' indices and the object. */
typedef struct AeroFace {
  aero_uint vertex[3];
  aero_uint object;
} AeroFace;

AERO_ASSERT_LAYOUT(AeroFace, 16);

/* Attributes of a vertex: unit normal, linear albedo (or the water's depth in color[0]) and where
 * on a surface with a look finer than its triangles it lies. */
typedef struct AeroVertex {
  aero_float position[3];
  aero_float normal[3];
  aero_float color[3];
  aero_float place[2];
} AeroVertex;

AERO_ASSERT_LAYOUT(AeroVertex, 44);

#endif
