#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace aerostat {

/// Where the system tells about memory; tests have folders of their own.
struct MemorySources {
  std::filesystem::path proc = "/proc";
  std::filesystem::path cgroups = "/sys/fs/cgroup";
  /// In bytes, of RLIMIT_AS and RLIMIT_DATA; nullopt: no limit.
  std::optional<std::uint64_t> address_space, data;

  static MemorySources of_process();
};

/// How many bytes more the process can have before the system refuses them or kills it, and what
/// sets that bound, such as "the free memory of the machine" or "the limit of its control group
/// (container)".
struct MemoryLeft {
  std::uint64_t bytes = 0;
  std::string bound;
};

/// The least of what the machine has free, what the control groups of the process allow (versions 1
/// and 2, with all groups above them; file caches count as free), and what its limits (ulimit -v
/// and -d) leave. What cannot be read sets no bound.
MemoryLeft memory_left(const MemorySources& sources = MemorySources::of_process());

/// The memory that a small render needs with PoCL, compiling its kernels: 291 MiB were measured.
inline constexpr std::uint64_t kLeastMemoryBytes = 320ull << 20;

/// Why a driver that compiles kernels had better not be loaded into so little memory, with figures
/// and what to do; empty if there is enough.
std::string memory_obstacle(const MemorySources& sources = MemorySources::of_process());

}  // namespace aerostat
