#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/confine.hpp"

namespace aerostat {

/// What a program that is run for us may use.
struct ChildLimits {
  std::uint64_t memory_bytes = std::uint64_t{4} << 30;
  std::uint64_t file_bytes = std::uint64_t{4} << 30;  // of each file that it writes
  int processor_s = 120;
  int waiting_s = 300;
  /// The files that it may use, where the system can enforce that; without them, any file.
  std::optional<ReachableFiles> files;
};

/// How a program ended.
struct ChildResult {
  int status = 0;  // its exit code, or 128 and the number of the signal that ended it
  bool took_too_long = false;
  std::string output;  // of both streams, at most 1 MiB
};

/// Runs a program and waits for it. `command` is its absolute path and its arguments; no shell
/// looks at them. It gets nothing but `environment` ("NAME=value"), an empty input, and no open
/// file of this process. Throws Error{io} if it cannot be started.
ChildResult run_limited(const std::vector<std::string>& command,
                        const std::vector<std::string>& environment, const ChildLimits& limits);

/// Returns whether a file is a program that this user may run.
bool is_program(const std::filesystem::path& file);

/// Returns where a program is: at the path that the environment variable gives, or else in a folder
/// of PATH. Returns an empty path if there is no such program, or if the variable names none.
std::filesystem::path find_program(const char* name, const char* variable);

/// Returns what a program that failed complained about, on one line, or how it ended.
std::string complaint_of(const ChildResult& result);

/// A new folder that only this user can read. It is removed with all that is in it.
class PrivateFolder {
 public:
  /// Throws Error{io} if it cannot be made.
  PrivateFolder();
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace aerostat
