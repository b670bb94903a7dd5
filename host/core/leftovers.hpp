#pragma once

#include <filesystem>
#include <string>

/// Names of temporary files, and the removal of those that killed runs left behind.
namespace aerostat {

/// Returns a name for a temporary file in a folder that no other file of this process has. It tells
/// the process, when that began, and in which system it runs.
std::filesystem::path temporary_name(const std::filesystem::path& folder);

/// Removes the temporary files in a folder whose processes are gone. Files of another machine or
/// container are removed when they are an hour old and no process has their number, because
/// processes there cannot be seen from here. Never fails.
void remove_leftovers(const std::filesystem::path& folder);

}  // namespace aerostat
