#pragma once

#include <filesystem>
#include <initializer_list>
#include <vector>

namespace aerostat {

/// The only files and folders, with all that is in them, that a program may use.
struct ReachableFiles {
  std::vector<std::filesystem::path> readable;  // and executable
  std::vector<std::filesystem::path> writable;
};

/// Returns the folders in which a system keeps its programs, their libraries and their data.
std::vector<std::filesystem::path> system_folders();

/// Returns the absolute folders that an environment variable lists with colons between them.
std::vector<std::filesystem::path> folders_in_variable(const char* name);

/// Returns the files that a program needs to run: the folders of the system, those of the program's
/// own installation, and those that LD_LIBRARY_PATH and `variables` name. It may write to `folder`
/// alone.
ReachableFiles files_of_program(const std::filesystem::path& program,
                                const std::filesystem::path& folder,
                                std::initializer_list<const char*> variables = {});

/// Takes from this thread, and from threads and programs that it starts, all other files and, on
/// newer systems, connections by TCP and signals to other processes. Nothing gives them back.
/// Returns false and does nothing if the system cannot do that; Linux can from 5.13 on, unless its
/// Landlock is switched off. Paths that do not exist are left out.
bool confine_this_thread(const ReachableFiles& files);

/// Returns whether files can be renamed from one writable folder to another in a confined thread.
/// Linux can do that from 5.19 on.
bool can_rename_confined();

/// Takes connections of every kind, but those by local sockets, from this thread and from threads
/// and programs that it starts. Returns false and does nothing if the system cannot do that.
bool refuse_connections();

}  // namespace aerostat
