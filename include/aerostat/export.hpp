#pragma once

/// Marks what the shared library shows to the programs that link it.
#if defined(__GNUC__)
#define AEROSTAT_API __attribute__((visibility("default")))
#else
#define AEROSTAT_API
#endif
