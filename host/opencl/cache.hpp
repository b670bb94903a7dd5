#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

/// Prepares the folder of PoCL's cache. PoCL keeps compiled kernels in this folder and loads code
/// from it, so the folder must be private. If PoCL cannot write there, it reports 'device not
/// found'. If the disk is full, it ends the process.
namespace aerostat::opencl {

/// The variables that decide where the cache folder is. Unset and empty variables are nullopt.
struct CacheEnvironment {
  std::optional<std::string> pocl_cache_dir;
  std::optional<std::string> xdg_cache_home;
  std::optional<std::string> home;
  std::optional<std::string> tmpdir;

  static CacheEnvironment of_process();
};

struct CacheFolder {
  std::filesystem::path path;
  /// Tells whether the folder is removed at exit.
  bool temporary = false;
  /// A sentence that warns the user, or an empty string if the folder is as it should be.
  std::string warning;
};

/// A kernel build may fail if less space than this is free on the disk.
inline constexpr std::uint64_t kMinCacheBytes = 32ull << 20;

/// Returns the path where the cache folder should be: $XDG_CACHE_HOME/aerostat/pocl, or else
/// $HOME/.cache/aerostat/pocl. Returns nothing if neither variable has an absolute path.
std::optional<std::filesystem::path> preferred_cache_path(const CacheEnvironment& environment);

/// Makes the cache folder and checks that it can be written. Uses POCL_CACHE_DIR as it is if the
/// user set it, else the preferred path with mode 0700, else a new private folder under the
/// temporary directory. Removes damaged kernels with a warning (see cache_check.hpp). Throws
/// Error{io} that names POCL_CACHE_DIR if no folder has `min_free_bytes` of free space, can be
/// written and can be cleared of damaged kernels.
CacheFolder prepare_cache(const CacheEnvironment& environment,
                          std::uint64_t min_free_bytes = kMinCacheBytes);

/// Makes a folder that no other user can read or write, and the folders above it. Returns why it
/// cannot, or nothing.
std::optional<std::string> make_private_folder(const std::filesystem::path& path);

/// Prepares the cache folder once per process, sets POCL_CACHE_DIR, warns if needed, and removes a
/// temporary folder at exit. Call it before the first call of OpenCL and before other threads run.
/// Returns a description of the problem, or an empty string.
std::string ensure_pocl_cache();

/// Makes the cache folder again if it was removed since ensure_pocl_cache().
void restore_pocl_cache();

/// Seals the kernels in PoCL's cache, so that a later run sees whether they were damaged since.
/// Call it after kernels were compiled and launched, because PoCL has loaded them then.
void keep_compiled_kernels();

}  // namespace aerostat::opencl
