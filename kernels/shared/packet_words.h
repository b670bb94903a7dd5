#ifndef AEROSTAT_SHARED_PACKET_WORDS_H
#define AEROSTAT_SHARED_PACKET_WORDS_H

#include "layout.h"

/* What one kernel hands to the next for each packet: a struct of lane vectors on the device. The
 * host allocates it by the words of a lane and never looks inside. The types keep the buffers
 * apart. */

/* Hit: distance, two barycentric coordinates, triangle, instance. */
typedef struct AeroHitWords {
  aero_uint words[5];
} AeroHitWords;
AERO_ASSERT_LAYOUT(AeroHitWords, 20);

/* The lights that reach a hit, as bits. */
typedef struct AeroVisibleWords {
  aero_uint words[1];
} AeroVisibleWords;
AERO_ASSERT_LAYOUT(AeroVisibleWords, 4);

/* AmbientFound: how much hides the sky. */
typedef struct AeroFoundWords {
  aero_uint words[2];
} AeroFoundWords;
AERO_ASSERT_LAYOUT(AeroFoundWords, 8);

/* PathState: the next ray, what it carries, what the path has found, and three rays to lights. */
typedef struct AeroPathWords {
  aero_uint words[50];
} AeroPathWords;
AERO_ASSERT_LAYOUT(AeroPathWords, 200);

/* Fails to compile if a struct of lane vectors has other words than the host allocates for it. */
#ifdef __OPENCL_C_VERSION__
#define AERO_ASSERT_PACKET(type, words) \
  typedef char aero_packet_of_##type[(sizeof(type) == LANES * sizeof(words)) ? 1 : -1]
#endif

#endif
