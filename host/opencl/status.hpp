#pragma once

#include <string>

#include "opencl/cl.hpp"

/// What OpenCL's statuses and exceptions mean. For sources: it brings in the bindings.
namespace aerostat::opencl {

/// The name of an OpenCL status, such as "CL_OUT_OF_RESOURCES".
std::string status_name(int status);

/// "CL_OUT_OF_RESOURCES from clBuildProgram"
std::string status_text(const cl::Error& error);

/// Whether a status says that there is too little memory.
bool is_out_of_memory(int status);

/// Whether `rethrow` would take a status for exhaustion: too little memory, or a device lost.
bool is_exhaustion(int status);

/// Throws an Error that says what was being done, with the right kind (out of memory and lost
/// devices: exhausted; everything else: internal).
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
