#pragma once

#include <string>

#include "opencl/cl.hpp"

/// Explains OpenCL's statuses and exceptions. Only sources include this header, because it includes
/// the bindings.
namespace aerostat::opencl {

/// Returns the name of an OpenCL status, such as "CL_OUT_OF_RESOURCES".
std::string status_name(int status);

/// Returns a text such as "CL_OUT_OF_RESOURCES from clBuildProgram".
std::string status_text(const cl::Error& error);

/// Returns whether a status reports too little memory.
bool is_out_of_memory(int status);

/// Returns whether `rethrow` treats a status as exhaustion, which is too little memory or a lost
/// device.
bool is_exhaustion(int status);

/// Throws an Error that says what was being done. Its kind is `exhausted` for too little memory and
/// lost devices, and `internal` for everything else.
[[noreturn]] void rethrow(const char* doing, const cl::Error& error);

/// Runs `f` and turns a cl::Error into an Error as `rethrow` does.
template <typename F>
decltype(auto) guarded(const char* doing, F&& f) {
  try {
    return f();
  } catch (const cl::Error& error) {
    rethrow(doing, error);
  }
}

}  // namespace aerostat::opencl
