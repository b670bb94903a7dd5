#ifndef AEROSTAT_SHARED_TEXTURE_H
#define AEROSTAT_SHARED_TEXTURE_H

#include "layout.h"

/* A texture of a model lies in the buffer of texels: a header of AERO_TEXTURE_HEADER words, and
 * then its levels, each half as wide and half as high as the one before, down to one texel. Rows go
 * from the top one on. A texel is a word whose lowest byte is red, and green, blue and opacity
 * follow. The bytes of colours are encoded in sRGB, and those of opacity and of data count
 * linearly. */

/* The words of the header: the size of the first level, then one of AERO_WRAP_... for u and for v
 * and whether texels show as squares, from the lowest byte on, the number of levels, and the place
 * of each level counted from the header's first word. */
#define AERO_TEXTURE_WIDTH 0
#define AERO_TEXTURE_HEIGHT 1
#define AERO_TEXTURE_WRAP 2
#define AERO_TEXTURE_LEVELS 3
#define AERO_TEXTURE_PLACES 4
#define AERO_TEXTURE_HEADER 20

/* The most levels that the header has room for: those of a side of 32768 texels. */
#define AERO_TEXTURE_MOST_LEVELS 16

/* What lies beyond the edges of a texture. */
#define AERO_WRAP_REPEAT 0
#define AERO_WRAP_MIRROR 1
#define AERO_WRAP_CLAMP 2

#endif
