#pragma once

#include <cstddef>
#include <filesystem>

/// Removes damaged files from PoCL's cache before PoCL is loaded. PoCL ends the process in every
/// run in which it finds a damaged file there. PoCL keeps each program in a folder "XX/HASH", which
/// contains program.bc (LLVM bitcode) and a shared library for each kernel and size of work-groups.
/// After libraries were loaded, a seal beside them records their sizes, times and checksums.
namespace aerostat::opencl {

/// Removes damaged programs from the cache and returns how many it removed. A program is damaged if
/// one of its files differs from its seal or cannot be opened, if a file without a seal is not
/// whole (cut off, empty or of another kind), or if a file stands in the place of a folder or a
/// folder in the place of a file. If the cache is marked as suspect, all programs and the mark are
/// removed. Waits for up to half a minute if another process compiles. Throws Error{io} that names
/// the path that cannot be removed.
std::size_t remove_damaged_programs(const std::filesystem::path& cache);

/// Returns the path of the file that marks the cache as suspect.
std::filesystem::path suspect_mark(const std::filesystem::path& cache);

/// Seals the programs in the cache. Programs that cannot be sealed stay as they are.
void seal_programs(const std::filesystem::path& cache);

}  // namespace aerostat::opencl
