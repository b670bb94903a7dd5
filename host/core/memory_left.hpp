#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace aerostat {

/// The places where the system tells about memory. Tests replace them with folders of their own.
struct MemorySources {
  std::filesystem::path proc = "/proc";
  std::filesystem::path cgroups = "/sys/fs/cgroup";
  /// The limits RLIMIT_AS and RLIMIT_DATA in bytes, or nothing if there is no limit.
  std::optional<std::uint64_t> address_space, data;

  static MemorySources of_process();
};

/// The number of bytes that the process can still have before the system refuses memory or kills
/// it. `bound` names what sets that number, such as "the free memory of the machine" or "the
/// limit of its control group (container)".
struct MemoryLeft {
  std::uint64_t bytes = 0;
  std::string bound;
};

/// Returns the least of three figures. The first is the memory that the machine has free. The
/// second is what the control groups of the process and all groups above them allow, in versions
/// 1 and 2, with file caches counted as free. The third is what the process's limits (ulimit -v
/// and -d) leave. A figure that cannot be read sets no bound.
MemoryLeft memory_left(const MemorySources& sources = MemorySources::of_process());

/// The memory that a small render with PoCL needs while it compiles its kernels. 291 MiB were
/// measured.
inline constexpr std::uint64_t kLeastMemoryBytes = 320ull << 20;

/// Returns why there is too little memory for a driver that compiles kernels, with the figures
/// that were found and needed. Returns an empty text if there is enough memory.
std::string memory_obstacle(const MemorySources& sources = MemorySources::of_process());

}  // namespace aerostat
