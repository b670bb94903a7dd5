#pragma once

#include <cstddef>
#include <filesystem>

/// PoCL ends the process when a file of its cache is damaged, in every run anew. So the cache is
/// looked through before PoCL is loaded. What PoCL keeps of a program lies in a folder "XX/HASH":
/// program.bc (LLVM bitcode), and a shared library for each kernel and size of work-groups. After
/// libraries were loaded, a seal beside them notes what they were like.
namespace aerostat::opencl {

/// Removes from the cache every program of which a file differs from its seal, has none and is not
/// whole (cut off, empty, not of its kind), cannot be opened, or is in a folder's place or the
/// other way round. Returns how many were removed. Throws Error{io} that names what cannot be
/// removed.
/// If the cache is marked as suspect, all are removed, and the mark with them.
std::size_t remove_damaged_programs(const std::filesystem::path& cache);

/// The file that marks the cache as suspect.
std::filesystem::path suspect_mark(const std::filesystem::path& cache);

/// Seals the programs in the cache. Those that cannot be sealed stay as they are.
void seal_programs(const std::filesystem::path& cache);

}  // namespace aerostat::opencl
