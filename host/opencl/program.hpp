#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "opencl/cl_names.hpp"
#include "opencl/device.hpp"

namespace aerostat::opencl {

/// Kernel sources by their paths relative to the kernel folder ("device/core/lanes.clh").
using SourceTree = std::map<std::string, std::string>;

/// Returns the folder that AEROSTAT_KERNEL_DIR names, from which kernels are read in place of those
/// in the binary, or nothing.
std::optional<std::filesystem::path> kernel_folder();

/// Returns the sources in the binary, or those of kernel_folder(). Throws Error{io} if the folder
/// cannot be read.
SourceTree kernel_sources();

/// Returns the sources in a folder. Throws Error{io} if it cannot be read.
SourceTree kernel_sources(const std::filesystem::path& folder);

/// Returns the text of `entry` with every `#include "..."` replaced by its file, once for each
/// file. A file is searched beside the including file, then under `device/`, `shared/` and the
/// tree's root. `#line` marks keep the places in messages right. `#include <...>` stays. Throws
/// Error{internal} with file and line if a file is missing, or if a file is included
/// unconditionally after it was included inside an `#if` that may hide it.
std::string flatten(const SourceTree& sources, const std::string& entry);

/// A context and an in-order queue (with profiling) on one device. Throws Error{exhausted} or
/// Error{no_device} with a description if the driver refuses.
class Context {
 public:
  explicit Context(Device device);

  const Device& device() const { return device_; }
  const cl::Context& handle() const { return *context_; }
  const std::shared_ptr<const cl::CommandQueue>& queue() const { return queue_; }

 private:
  Device device_;
  std::shared_ptr<const cl::Context> context_;
  std::shared_ptr<const cl::CommandQueue> queue_;
};

/// A kernel and its arguments. Copies share the arguments.
using Kernel = std::shared_ptr<cl::Kernel>;

/// Returns the options with which every program of the product is built, for `lanes` rays per
/// work-item.
std::string build_options(int lanes);

/// A built program. Extra sources (such as a test's probe) may include the product's headers.
class Program {
 public:
  /// Builds `entry` of `sources` for `lanes` in {1, 4, 8, 16}. `defines` are further "NAME=VALUE"
  /// macros. Takes the machine code of a former run if it is kept (see binaries.hpp). Throws
  /// Error{internal} with the build log.
  Program(const Context& context, const SourceTree& sources, const std::string& entry, int lanes,
          const std::vector<std::string>& defines = {});

  /// Returns a new kernel object. Throws Error{internal} if the driver makes none of that name,
  /// either because the program contains none or because the driver's compiler failed.
  Kernel kernel(const std::string& name) const;

  int lanes() const { return lanes_; }

 private:
  void build(const Context& context, const std::string& text, const std::string& options);
  bool take_binary(const Context& context, const std::string& binary, const std::string& options);
  std::string binary() const;

  std::shared_ptr<cl::Program> program_;
  /// A description of the device for messages.
  std::string device_;
  /// A description of the sources for messages.
  std::string entry_;
  int lanes_ = 1;
};

}  // namespace aerostat::opencl
