#include "core/memory_left.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

namespace aerostat {
namespace {

namespace fs = std::filesystem;

/// The least address space for a driver. Drivers reserve many times the address space that they
/// use. With 2 cores, PoCL compiles in 700 to 800 MiB and fails to compile in 600 MiB.
constexpr std::uint64_t kLeastAddressSpace = 768ull << 20;
/// The address space added for each core, whose threads have stacks of their own.
constexpr std::uint64_t kAddressSpacePerCore = 24ull << 20;

std::optional<std::uint64_t> limit_of(__rlimit_resource resource) {
  rlimit limit = {};
  if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::nullopt;
  return limit.rlim_cur;
}

/// Returns the number at the beginning of a file. Returns nothing for the word "max" or a missing
/// file.
std::optional<std::uint64_t> number_in(const fs::path& file) {
  std::ifstream stream(file);
  std::uint64_t value = 0;
  if (stream >> value) return value;
  return std::nullopt;
}

/// Returns the number behind a word in a file of words and numbers, or 0 if the word is missing.
std::uint64_t number_behind(const fs::path& file, const std::string& word) {
  std::ifstream stream(file);
  std::string found;
  while (stream >> found) {
    std::uint64_t value = 0;
    if (found == word && stream >> value) return value;
  }
  return 0;
}

std::uint64_t minus(std::uint64_t a, std::uint64_t b) {
  return a > b ? a - b : 0;
}

void lower(MemoryLeft& left, std::uint64_t bytes, const char* bound) {
  if (bytes < left.bytes) left = {bytes, bound};
}

/// The names of the files of one version of control groups.
struct GroupFiles {
  const char* usage;
  const char* cache;  // key in memory.stat: file pages that can be dropped
  std::vector<const char*> limits;
};
GroupFiles version_1() {
  return {"memory.usage_in_bytes", "total_inactive_file", {"memory.limit_in_bytes"}};
}

GroupFiles version_2() {
  return {"memory.current", "inactive_file", {"memory.max", "memory.high"}};
}

void lower_by_group(MemoryLeft& left, const fs::path& group, const GroupFiles& files) {
  const auto usage = number_in(group / files.usage);
  if (!usage) return;
  const auto in_use = minus(*usage, number_behind(group / "memory.stat", files.cache));
  for (const char* const name : files.limits) {
    if (const auto limit = number_in(group / name)) {
      lower(left, minus(*limit, in_use), "the limit of its control group (container)");
    }
  }
}

/// Lowers `left` to what a group and all groups above it allow. A container may mount its own
/// group as the root while the path is the one seen from outside. In that case only the root is
/// found.
void lower_by_groups(MemoryLeft& left, const fs::path& root, const fs::path& path,
                     const GroupFiles& files) {
  for (fs::path at = path.relative_path();; at = at.parent_path()) {
    lower_by_group(left, root / at, files);
    if (at.empty()) return;
  }
}

/// Lowers `left` to what the control groups of the process allow. Lines of the file are
/// "ID:CONTROLLERS:PATH". Version 2 names no controllers.
void lower_by_cgroups(MemoryLeft& left, const MemorySources& sources) {
  std::ifstream lines(sources.proc / "self" / "cgroup");
  for (std::string line; std::getline(lines, line);) {
    const auto first = line.find(':');
    const auto second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const auto controllers = fmt::format(",{},", line.substr(first + 1, second - first - 1));
    const fs::path path = line.substr(second + 1);
    if (controllers == ",,") {
      lower_by_groups(left, sources.cgroups, path, version_2());
      lower_by_groups(left, sources.cgroups / "unified", path, version_2());
    } else if (controllers.find(",memory,") != std::string::npos) {
      lower_by_groups(left, sources.cgroups / "memory", path, version_1());
    }
  }
}

std::uint64_t mebibytes(std::uint64_t bytes) {
  return bytes >> 20;
}

}  // namespace

MemorySources MemorySources::of_process() {
  MemorySources sources;
  sources.address_space = limit_of(RLIMIT_AS);
  sources.data = limit_of(RLIMIT_DATA);
  return sources;
}

MemoryLeft memory_left(const MemorySources& sources) {
  MemoryLeft left{std::numeric_limits<std::uint64_t>::max(), "nothing"};
  const fs::path meminfo = sources.proc / "meminfo";
  const auto free_kib =
      number_behind(meminfo, "MemAvailable:") + number_behind(meminfo, "SwapFree:");
  if (free_kib > 0) lower(left, free_kib * 1024, "the free memory of the machine");
  lower_by_cgroups(left, sources);
  const fs::path status = sources.proc / "self" / "status";
  if (sources.address_space) {
    const auto in_use = number_behind(status, "VmSize:") * 1024;
    lower(left, minus(*sources.address_space, in_use),
          "the limit of its address space (ulimit -v)");
  }
  if (sources.data) {
    const auto in_use = number_behind(status, "VmData:") * 1024;
    lower(left, minus(*sources.data, in_use), "the limit of its data (ulimit -d)");
  }
  return left;
}

std::string memory_obstacle(const MemorySources& sources) {
  const auto least_space =
      kLeastAddressSpace + kAddressSpacePerCore * std::max(1u, std::thread::hardware_concurrency());
  if (sources.address_space && *sources.address_space < least_space) {
    return fmt::format(
        "there is not enough memory for an OpenCL driver and its compiler: the address space is "
        "limited to {} MiB (ulimit -v), at least {} MiB are needed",
        mebibytes(*sources.address_space), mebibytes(least_space));
  }
  const MemoryLeft left = memory_left(sources);
  if (left.bytes >= kLeastMemoryBytes) return {};
  return fmt::format(
      "there is not enough memory for an OpenCL driver and its compiler: {} leaves {} MiB, at "
      "least {} MiB are needed",
      left.bound, mebibytes(left.bytes), mebibytes(kLeastMemoryBytes));
}

}  // namespace aerostat
