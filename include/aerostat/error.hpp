#pragma once

#include <stdexcept>
#include <string>

#include "aerostat/export.hpp"

namespace aerostat {

/// What went wrong, and whose fault it is. The value is the exit code of the programs (sysexits.h
/// where it has one).
enum class ErrorKind : int {
  usage = 64,         ///< wrong command line, or wrong arguments of a call
  bad_data = 65,      ///< a scene or data file that cannot be used
  no_device = 69,     ///< no OpenCL device, or not the one asked for; no display for a window
  internal = 70,      ///< a fault of aerostat's own, or a kernel that does not build
  io = 74,            ///< a file that cannot be read or written
  exhausted = 75,     ///< out of memory, or the device was lost
  interrupted = 130,  ///< stopped by the user
};

/// The only exception aerostat throws on purpose. The message says what was being done, what was
/// found and what was expected, and needs no context to be read.
class AEROSTAT_API Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}

  ErrorKind kind() const { return kind_; }
  int exit_code() const { return static_cast<int>(kind_); }

 private:
  ErrorKind kind_;
};

}  // namespace aerostat
