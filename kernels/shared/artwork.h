#ifndef AEROSTAT_SHARED_ARTWORK_H
#define AEROSTAT_SHARED_ARTWORK_H

#include "layout.h"

/* The pictures on the envelope of a balloon, as words in the buffer of texels: a header of
 * AERO_ARTWORK_LAYERS words, then AERO_ARTWORK_WORDS for each picture, the later ones over the
 * former. All words but the numbers of pictures and the places of textures are the bits of floats.
 * Heights are metres along the cloth from the mouth, and places around are in gores, as u of the
 * envelope's texture coordinates. */

#define AERO_ARTWORK_COUNT 0  /* number of pictures */
#define AERO_ARTWORK_PANELS 1 /* panels up to the parachute disc */
#define AERO_ARTWORK_PANEL 2  /* height of a panel */
#define AERO_ARTWORK_DISC 3   /* length of the cloth from the rim of the disc to the crown */
#define AERO_ARTWORK_STEP 4   /* difference of height between two widths */
#define AERO_ARTWORK_WIDTHS 5 /* widths of a gore, from the mouth on */
#define AERO_ARTWORK_WIDTH_COUNT 129
#define AERO_ARTWORK_LAYERS 134 /* place of the first picture */

/* The most pictures of one envelope: scene::kMostArtwork. */
#define AERO_MOST_ARTWORK 16

/* The words of a picture. */
#define AERO_ARTWORK_TEXTURE 0 /* place of the texture in the buffer */
#define AERO_ARTWORK_MIDDLE 1  /* place of its middle around */
#define AERO_ARTWORK_PERIOD 2  /* distance between two copies */
#define AERO_ARTWORK_FROM 3    /* heights of its lower and upper edge */
#define AERO_ARTWORK_TO 4
#define AERO_ARTWORK_WIDTH 5 /* width of a motif in metres, or 0 if it fills its period */
#define AERO_ARTWORK_WORDS 6

#endif
