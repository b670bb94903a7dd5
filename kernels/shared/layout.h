#ifndef AEROSTAT_SHARED_LAYOUT_H
#define AEROSTAT_SHARED_LAYOUT_H

/* Scalar types of the structs that host and device both read, and the check that both see the same
 * layout. These headers hold data only: 32-bit scalars and arrays of them. */
#ifdef __OPENCL_C_VERSION__
typedef float aero_float;
typedef uint aero_uint;
typedef int aero_int;
#define AERO_ASSERT_LAYOUT(type, bytes) \
  typedef char aero_layout_of_##type[(sizeof(type) == (bytes)) ? 1 : -1]
#define AERO_ALIGNED_ON_HOST(bytes)
#else
#include <stdint.h>
typedef float aero_float;
typedef uint32_t aero_uint;
typedef int32_t aero_int;
#define AERO_ASSERT_LAYOUT(type, bytes) static_assert(sizeof(type) == (bytes), #type)
#define AERO_ALIGNED_ON_HOST(bytes) alignas(bytes)
#endif

#endif
