#pragma once

namespace aerostat::opencl {

/// A driver's compiler ends the process by abort() where it lacks memory or stumbles over its own
/// files, and no exception tells of it. While one of these lives, an abort is told in words that
/// name PoCL's cache, and exits with the code of `internal`, or of `exhausted` if the address space
/// is limited. The cache is marked as suspect then: the next run begins with an empty one. For the
/// time in which kernels are compiled and first launched; several may live at once.
class DriverAbortGuard {
 public:
  DriverAbortGuard();
  ~DriverAbortGuard();
  DriverAbortGuard(const DriverAbortGuard&) = delete;
  DriverAbortGuard& operator=(const DriverAbortGuard&) = delete;
};

}  // namespace aerostat::opencl
