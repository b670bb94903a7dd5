#pragma once

/// AEROSTAT_API marks the names that the shared library exports. AEROSTAT_HIDDEN marks the
/// members of an exported class that the library does not export.
#if defined(__GNUC__)
#define AEROSTAT_API __attribute__((visibility("default")))
#define AEROSTAT_HIDDEN __attribute__((visibility("hidden")))
#else
#define AEROSTAT_API
#define AEROSTAT_HIDDEN
#endif
