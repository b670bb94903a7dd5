#pragma once

#include <stdexcept>
#include <string>

#include "aerostat/export.hpp"

namespace aerostat {

/// The kind of an error, which tells whose fault it is. The value is the exit code of the
/// programs, from sysexits.h where that has a fitting code.
enum class ErrorKind : int {
  usage = 64,         ///< wrong command line, or wrong arguments of a call
  bad_data = 65,      ///< a scene or data file that cannot be used
  no_device = 69,     ///< no OpenCL device, no display, or no Open Image Denoise
  internal = 70,      ///< a fault of aerostat itself, or a kernel that does not build
  io = 74,            ///< a file that cannot be read or written
  exhausted = 75,     ///< out of memory, or the device was lost
  interrupted = 130,  ///< stopped by the user
};

/// The only exception that aerostat throws on purpose. The message tells what was being done,
/// what was found and what was expected. It can be read without any context.
class AEROSTAT_API Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}

  ErrorKind kind() const { return kind_; }
  int exit_code() const { return static_cast<int>(kind_); }

 private:
  ErrorKind kind_;
};

}  // namespace aerostat
