#pragma once

namespace aerostat::opencl {

/// Reports an abort of the driver while an object of this type exists. A driver's compiler calls
/// abort() when it lacks memory or finds its own files damaged, and throws no exception. The guard
/// then prints a message that names PoCL's cache, and exits with the code of `internal`, or with
/// that of `exhausted` if the address space is limited. It also marks the cache as suspect, so that
/// the next run begins with an empty cache. Meanwhile no other process of aerostat removes programs
/// from the cache (see cache_use.hpp). Use a guard while kernels are compiled and launched for the
/// first time. Several guards may exist at once.
class DriverAbortGuard {
 public:
  DriverAbortGuard();
  ~DriverAbortGuard();
  DriverAbortGuard(const DriverAbortGuard&) = delete;
  DriverAbortGuard& operator=(const DriverAbortGuard&) = delete;
};

}  // namespace aerostat::opencl
