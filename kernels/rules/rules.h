#ifndef AEROSTAT_RULES_RULES_H
#define AEROSTAT_RULES_RULES_H

#include "layout.h"

/* Defines the words in which rules are written. A rule is a function that host and device both
 * compile, so that what both decide is decided in one place. Rules are OpenCL C and C++ at once:
 * functions over scalars of each lane, in the lane types of the device (core/lanes.clh).
 *
 * The device compiles a rule for all lanes of a work-item. The host compiles it for one lane, in
 * the namespace aerostat::rules, and may run it in loops that the compiler makes vectors of. A rule
 * that reads a struct takes a pointer marked AERO_GLOBAL.
 *
 * The host's lane_fma() rounds twice, because not all processors have a fused operation and the
 * host's results are the same on all of them. Results of a rule that uses it, or a function such as
 * exp(), therefore differ between host and device by rounding.
 *
 * A rule marked AERO_REAL_RULE has numbers of the type lane_real, which is lane_float on the
 * device, and float or double on the host. Its constants are exact in single precision. */
#ifdef __OPENCL_C_VERSION__

#include "core/lanes.clh"
#define AERO_RULE inline
#define AERO_REAL_RULE inline
#define AERO_GLOBAL __global
#define AERO_RULES_BEGIN
#define AERO_RULES_END
typedef lane_float lane_real;

#else

#include <bit>
#include <cmath>

#if defined(__GNUC__)
#define AERO_RULE inline __attribute__((always_inline))
#else
#define AERO_RULE inline
#endif
#define AERO_REAL_RULE          \
  template <typename lane_real> \
  AERO_RULE
#define AERO_GLOBAL
#define AERO_RULES_BEGIN namespace aerostat::rules {
#define AERO_RULES_END }

AERO_RULES_BEGIN

typedef aero_float lane_float;
typedef aero_int lane_int;
typedef aero_uint lane_uint;

AERO_RULE lane_int lane_mask(bool comparison) {
  return -static_cast<lane_int>(comparison);
}
template <typename T>
AERO_RULE T lane_select(lane_int mask, T a, T b) {
  return mask != 0 ? a : b;
}
AERO_REAL_RULE lane_real lane_min(lane_real a, lane_real b) {
  return a < b ? a : b;
}
AERO_REAL_RULE lane_real lane_max(lane_real a, lane_real b) {
  return a > b ? a : b;
}
AERO_REAL_RULE lane_real lane_fma(lane_real a, lane_real b, lane_real c) {
  return a * b + c;
}
AERO_RULE lane_float lane_floor(lane_float x) {
  return std::floor(x);
}
AERO_RULE lane_int lane_to_int(lane_float x) {
  return static_cast<lane_int>(x);
}
AERO_RULE lane_float lane_from_uint(lane_uint x) {
  return static_cast<lane_float>(x);
}
AERO_RULE lane_float lane_from_int(lane_int x) {
  return static_cast<lane_float>(x);
}
AERO_RULE lane_int lane_as_int(lane_uint x) {
  return static_cast<lane_int>(x);
}
AERO_RULE lane_uint lane_as_uint(lane_int x) {
  return static_cast<lane_uint>(x);
}
AERO_RULE lane_uint lane_as_uint(lane_float x) {
  return std::bit_cast<lane_uint>(x);
}
AERO_RULE lane_float lane_as_float(lane_uint x) {
  return std::bit_cast<lane_float>(x);
}
AERO_RULE lane_float fabs(lane_float x) {
  return std::fabs(x);
}
AERO_RULE lane_float sqrt(lane_float x) {
  return std::sqrt(x);
}
AERO_REAL_RULE lane_real exp(lane_real x) {
  return std::exp(x);
}
AERO_RULE lane_float log(lane_float x) {
  return std::log(x);
}
AERO_RULE lane_float copysign(lane_float magnitude, lane_float sign) {
  return std::copysign(magnitude, sign);
}
AERO_RULE lane_float sinpi(lane_float x) {
  return std::sin(3.14159265f * x);
}

AERO_RULES_END

#endif

#endif
