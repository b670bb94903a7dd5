#pragma once

#include <chrono>
#include <filesystem>

namespace aerostat::opencl {

/// The use of PoCL's cache by this process, which other processes of aerostat see as a lock on a
/// file in the cache. Processes that compile share the cache. One that removes programs uses it
/// alone, because PoCL fails or ends the process if a folder vanishes into which it compiles. If
/// the file cannot be locked, the cache is used all the same.
class CacheUse {
 public:
  enum class Kind { shared, alone };

  /// Waits until no other process uses the cache in a way that excludes this one, but no longer
  /// than `patience`.
  CacheUse(const std::filesystem::path& cache, Kind kind,
           std::chrono::milliseconds patience = std::chrono::seconds(30));
  ~CacheUse();
  CacheUse(const CacheUse&) = delete;
  CacheUse& operator=(const CacheUse&) = delete;

 private:
  int file_ = -1;
};

}  // namespace aerostat::opencl
