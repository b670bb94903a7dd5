#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include "core/error.hpp"

/// What the readers need to be called with bytes in place of a file.
namespace aerostat::test {

/// The name that fault_of() expects in messages.
inline const std::filesystem::path kPath = "11/385/803.fuzz";

/// Reports a fault that a reader would hide from its caller.
[[noreturn]] inline void complain(const std::string& what) {
  throw Error(ErrorKind::internal, what);
}

/// A file that exists only in memory.
class MemoryFile {
 public:
  explicit MemoryFile(std::span<const std::uint8_t> bytes) : descriptor_(memfd_create("fuzz", 0)) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written != static_cast<ssize_t>(bytes.size())) complain("the file cannot be written");
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

/// Runs an action. If that throws Error{bad_data}, throws the same error with the file's name in
/// front of its message, as readers of whole files do.
template <typename Action>
void naming_the_file(Action action) {
  try {
    action();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_data) throw;
    throw Error(ErrorKind::bad_data, kPath.string() + ": " + error.what());
  }
}

}  // namespace aerostat::test
