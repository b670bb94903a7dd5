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

/* Ids of objects that the kernels write into a picture. The host gives the others. */
#define AERO_OBJECT_SKY 0
#define AERO_OBJECT_TERRAIN 1 /* the height grid */

/* A triangle as shading reads it: the indices of its three vertices, the id of its object, and two
 * numbers in one word. The lower half of `material` is the number of the material in
 * AeroScene::materials. The upper half is the number in AeroScene::balloons of the balloon that the
 * triangle belongs to, or 0. Faces are in the order of the tree's leaves. */
typedef struct AeroFace {
  aero_uint vertex[3];
  aero_uint object;
  aero_uint material;
} AeroFace;

#define AERO_FACE_BALLOON_SHIFT 16
#define AERO_FACE_MATERIAL_MASK 0xffff

AERO_ASSERT_LAYOUT(AeroFace, 20);

/* Attributes of a vertex: the position, the unit normal, the linear albedo, and uv for materials
 * with detail that is finer than triangles. color[0] of a water's vertex is the depth of the
 * water. */
typedef struct AeroVertex {
  aero_float position[3];
  aero_float normal[3];
  aero_float color[3];
  aero_float uv[2];
} AeroVertex;

AERO_ASSERT_LAYOUT(AeroVertex, 44);

#endif
