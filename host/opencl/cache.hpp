#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

/// PoCL keeps compiled kernels in a folder and loads code from it: it must be private. Where it
/// cannot write there, it says 'device not found'; where the disk is full, it ends the process.
namespace aerostat::opencl {

/// The variables that decide where the folder is; unset and empty ones are nullopt.
struct CacheEnvironment {
  std::optional<std::string> pocl_cache_dir;
  std::optional<std::string> xdg_cache_home;
  std::optional<std::string> home;
  std::optional<std::string> tmpdir;

  static CacheEnvironment of_process();
};

struct CacheFolder {
  std::filesystem::path path;
  bool temporary = false;  // to be removed at exit
  std::string warning;     // a sentence for the user if it is not as it should be
};

/// Free space below which a kernel build may fail for lack of it.
inline constexpr std::uint64_t kMinCacheBytes = 32ull << 20;

/// Where the folder should be: $XDG_CACHE_HOME/aerostat/pocl, else $HOME/.cache/aerostat/pocl, else
/// nowhere. Relative values do not count.
std::optional<std::filesystem::path> preferred_cache_path(const CacheEnvironment& environment);

/// Makes the folder and proves that it can be written: the user's POCL_CACHE_DIR as it is, else the
/// preferred one with mode 0700, else a new private one under the temporary directory. Removes
/// damaged kernels (see cache_check.hpp), with a warning. Throws Error{io} that names
/// POCL_CACHE_DIR if no folder has `min_free_bytes`, can be written and is rid of damaged kernels.
CacheFolder prepare_cache(const CacheEnvironment& environment,
                          std::uint64_t min_free_bytes = kMinCacheBytes);

/// Makes a folder, and those above it, that no other user can write to or read. Returns why it
/// cannot, or nothing.
std::optional<std::string> make_private_folder(const std::filesystem::path& path);

/// Prepares the folder once per process, sets POCL_CACHE_DIR, warns where needed, and removes a
/// temporary folder at exit. Call it before the first call of OpenCL and before other threads run.
/// Returns what is wrong, or an empty string.
std::string ensure_pocl_cache();

/// Notes what the kernels in PoCL's folder are like, now that PoCL has loaded them, so that a later
/// run sees whether they were damaged since. Call it when kernels were compiled and launched.
void keep_compiled_kernels();

}  // namespace aerostat::opencl
