/* Includes every kernel of a render by the path integrator (see render.cl). */
#include "film.cl"
#include "follow_paths.cl"
#include "note_guides.cl"
