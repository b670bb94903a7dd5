#include "opencl/program.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace aerostat::opencl {
namespace {

// A broken header can produce megabytes of messages; the first ones tell the cause.
constexpr std::size_t kMaxLogBytes = 16384;

std::string shortened(std::string log) {
  if (log.size() <= kMaxLogBytes) return log;
  const auto left_out = log.size() - kMaxLogBytes;
  log.resize(kMaxLogBytes);
  return log + fmt::format("\n... and {} bytes more", left_out);
}

std::string options_with(int lanes, const std::vector<std::string>& defines) {
  std::string options = build_options(lanes);
  for (const auto& define : defines) {
    if (define.empty() || define.find_first_of(" \t\n\"'") != std::string::npos) {
      throw Error(ErrorKind::internal,
                  fmt::format("\"{}\" cannot be a macro of a kernel build", define));
    }
    options += " -D" + define;
  }
  return options;
}

[[noreturn]] void throw_build_error(const Device& device, const std::string& entry,
                                    const std::string& options, const cl::BuildError& error) {
  std::string log;
  for (const auto& part : error.getBuildLog()) log += part.second;
  throw Error(ErrorKind::internal,
              fmt::format("the kernels of {} do not build for {} {} with {} ({}):\n{}", entry,
                          device.selector(), device.name, options, status_name(error.err()),
                          shortened(log)));
}

}  // namespace

Context::Context(Device device) : device_(std::move(device)) {
  const auto doing = fmt::format("opening the device {} {}", device_.selector(), device_.name);
  try {
    context_ = cl::Context(device_.handle);
    queue_ = cl::CommandQueue(context_, device_.handle, CL_QUEUE_PROFILING_ENABLE);
  } catch (const cl::Error& error) {
    const bool memory = error.err() == CL_OUT_OF_HOST_MEMORY ||
                        error.err() == CL_OUT_OF_RESOURCES ||
                        error.err() == CL_MEM_OBJECT_ALLOCATION_FAILURE;
    if (memory) rethrow(doing.c_str(), error);
    throw Error(ErrorKind::no_device, fmt::format("while {}: the driver refuses ({} from {})",
                                                  doing, status_name(error.err()), error.what()));
  }
}

std::string build_options(int lanes) {
  if (lanes != 1 && lanes != 4 && lanes != 8 && lanes != 16) {
    throw Error(ErrorKind::usage, fmt::format("{} lanes: expected 1, 4, 8 or 16", lanes));
  }
  // Warnings are for `scripts/lint kernels`: a driver would print its own on the user's terminal.
  return fmt::format("-cl-std=CL1.2 -w -DLANES={}", lanes);
}

Program::Program(const Context& context, const SourceTree& sources, const std::string& entry,
                 int lanes, const std::vector<std::string>& defines)
    : entry_(entry), lanes_(lanes) {
  const auto options = options_with(lanes, defines);
  const auto text = flatten(sources, entry);
  const auto doing = fmt::format("building the kernels of {}", entry);
  guarded(doing.c_str(), [&] {
    program_ = cl::Program(context.handle(), text);
    try {
      program_.build({context.device().handle}, options.c_str());
    } catch (const cl::BuildError& error) {
      if (error.err() == CL_OUT_OF_HOST_MEMORY || error.err() == CL_OUT_OF_RESOURCES) throw;
      throw_build_error(context.device(), entry, options, error);
    }
  });
}

cl::Kernel Program::kernel(const std::string& name) const {
  try {
    return cl::Kernel(program_, name.c_str());
  } catch (const cl::Error& error) {
    if (error.err() == CL_INVALID_KERNEL_NAME) {
      throw Error(ErrorKind::internal, fmt::format("{} has no kernel \"{}\"", entry_, name));
    }
    rethrow(fmt::format("making the kernel {} of {}", name, entry_).c_str(), error);
  }
}

}  // namespace aerostat::opencl
