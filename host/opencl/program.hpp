#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "opencl/device.hpp"

namespace aerostat::opencl {

/// Kernel sources by path relative to the kernel folder ("device/core/lanes.clh").
using SourceTree = std::map<std::string, std::string>;

/// The sources in the binary, or those of the folder AEROSTAT_KERNEL_DIR if that is set.
/// Throws Error{io} if the folder cannot be read.
SourceTree kernel_sources();

/// The sources in a folder, likewise.
SourceTree kernel_sources(const std::filesystem::path& folder);

/// `entry` with every `#include "..."` replaced by its file (once each, found beside the including
/// file, then under `device/`, `shared/` and the tree's root), and `#line` marks that keep messages
/// true. `#include <...>` stays. Throws Error{internal} with file and line if a file is missing, or
/// if it is included for everyone after it was included inside an `#if` that may hide it.
std::string flatten(const SourceTree& sources, const std::string& entry);

/// A context and an in-order queue (with profiling) on one device. Throws Error{exhausted} or
/// Error{no_device} in words if the driver refuses.
class Context {
 public:
  explicit Context(Device device);

  const Device& device() const { return device_; }
  const cl::Context& handle() const { return context_; }
  const cl::CommandQueue& queue() const { return queue_; }

 private:
  Device device_;
  cl::Context context_;
  cl::CommandQueue queue_;
};

/// The options every program of the product is built with, for `lanes` rays per work-item.
std::string build_options(int lanes);

/// A built program. Extra sources (a test's probe) may include the product's headers.
class Program {
 public:
  /// Builds `entry` of `sources` for `lanes` in {1, 4, 8, 16}; `defines` are further "NAME=VALUE"
  /// macros. Takes the machine code of a former run where that is kept (see binaries.hpp). Throws
  /// Error{internal} with the build log.
  Program(const Context& context, const SourceTree& sources, const std::string& entry, int lanes,
          const std::vector<std::string>& defines = {});

  /// A new kernel object. Throws Error{internal} if the driver makes none of that name, be it that
  /// the program has none or that the driver's compiler failed at it.
  cl::Kernel kernel(const std::string& name) const;

  int lanes() const { return lanes_; }

 private:
  void build(const Context& context, const std::string& text, const std::string& options);
  bool take_binary(const Context& context, const std::string& binary, const std::string& options);
  std::string binary() const;

  cl::Program program_;
  std::string device_;  // in words
  std::string entry_;
  int lanes_ = 1;
};

/// Runs `f` and turns a cl::Error into an Error that says what was being done, with the right kind
/// (out of memory and lost devices: exhausted; everything else: internal).
template <typename F>
decltype(auto) guarded(const char* doing, F&& f);

[[noreturn]] void rethrow(const char* doing, const cl::Error& error);

template <typename F>
decltype(auto) guarded(const char* doing, F&& f) {
  try {
    return f();
  } catch (const cl::Error& error) {
    rethrow(doing, error);
  }
}

/// The name of an OpenCL status, such as "CL_OUT_OF_RESOURCES".
std::string status_name(int status);

/// "CL_OUT_OF_RESOURCES from clBuildProgram"
std::string status_text(const cl::Error& error);

/// Whether a status says that there is too little memory.
bool is_out_of_memory(int status);

/// Whether `rethrow` would take a status for exhaustion: too little memory, or a device lost.
bool is_exhaustion(int status);

}  // namespace aerostat::opencl
