#pragma once

/// AEROSTAT_API marks what the shared library shows to the programs that link it, AEROSTAT_HIDDEN
/// what it does not show of a class that it shows.
#if defined(__GNUC__)
#define AEROSTAT_API __attribute__((visibility("default")))
#define AEROSTAT_HIDDEN __attribute__((visibility("hidden")))
#else
#define AEROSTAT_API
#define AEROSTAT_HIDDEN
#endif
