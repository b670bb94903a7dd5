#pragma once

#include <filesystem>
#include <vector>

namespace aerostat {

/// The only files and folders, with all that is in them, that a program may use.
struct ReachableFiles {
  std::vector<std::filesystem::path> readable;  // and executable
  std::vector<std::filesystem::path> writable;
};

/// Takes from this thread, and from programs that it starts, all other files and, on newer systems,
/// connections by TCP. Nothing gives them back. Returns false and does nothing if the system cannot
/// do that; Linux can from 5.13 on, unless its Landlock is switched off. Paths that do not exist
/// are left out.
bool confine_this_thread(const ReachableFiles& files);

}  // namespace aerostat
