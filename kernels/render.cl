/* Includes every kernel of a render. The host builds them as one program: a driver takes longer to
 * find a program among those that it has compiled than to load it, because it first preprocesses
 * the text and its own headers. */
#include "film.cl"
#include "note_guides.cl"
#include "shade_hits.cl"
#include "trace_ambient.cl"
#include "trace_camera.cl"
#include "trace_shadow.cl"
