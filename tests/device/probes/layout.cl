#include "bvh_node.h"
#include "camera.h"
#include "film_pixel.h"
#include "geometry/ray.clh"
#include "instance.h"
#include "packet_words.h"
#include "scene_params.h"
#include "trace_triangle.h"

#define STRUCT(type) out[n++] = (uint)sizeof(type);
#define FIELD(type, field)                                \
  out[n++] = (uint)(size_t)(&((__global type*)0)->field); \
  out[n++] = (uint)sizeof(((__global type*)0)->field);

/* Stores the sizes of the structs, and the offsets and sizes of their fields, in the order of the
 * list. */
__kernel void report_layout(__global uint* out) {
  uint n = 0u;
#include "layout_fields.h"
}

/* Stores the size of a packet of hits, and the offsets in it. */
__kernel void report_hit(__global uint* out) {
  out[0] = (uint)sizeof(Hit);
  out[1] = (uint)(size_t)(&((__global Hit*)0)->t);
  out[2] = (uint)(size_t)(&((__global Hit*)0)->u);
  out[3] = (uint)(size_t)(&((__global Hit*)0)->v);
  out[4] = (uint)(size_t)(&((__global Hit*)0)->triangle);
  out[5] = (uint)(size_t)(&((__global Hit*)0)->instance);
}
