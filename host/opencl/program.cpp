#include "opencl/program.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "opencl/binaries.hpp"
#include "opencl/status.hpp"

namespace aerostat::opencl {
namespace {

// The most bytes of a build log that a message contains. A broken header can produce megabytes of
// messages, and the first ones tell the cause.
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

/// Returns a description of a program's sources for messages.
std::string described(const std::string& entry) {
  const auto folder = kernel_folder();
  return folder ? fmt::format("{} in {} (AEROSTAT_KERNEL_DIR)", entry, folder->string()) : entry;
}

/// Returns what the driver says about a build that failed.
std::string build_log(const cl::Program& program, const cl::Device& device) {
  try {
    return program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device);
  } catch (const cl::Error&) {
    return "(the driver gives no log)";
  }
}

[[noreturn]] void throw_build_error(const Device& device, const std::string& entry,
                                    const std::string& options, int status,
                                    const std::string& log) {
  throw Error(
      ErrorKind::internal,
      fmt::format("the kernels of {} do not build for {} {} with {} ({}):\n{}", entry,
                  device.selector(), device.name, options, status_name(status), shortened(log)));
}

}  // namespace

Context::Context(Device device) : device_(std::move(device)) {
  const auto doing = fmt::format("opening the device {} {}", device_.selector(), device_.name);
  try {
    context_ = std::make_shared<cl::Context>(*device_.handle);
    queue_ =
        std::make_shared<cl::CommandQueue>(*context_, *device_.handle, CL_QUEUE_PROFILING_ENABLE);
  } catch (const cl::Error& error) {
    const bool is_gone = error.err() == CL_DEVICE_NOT_AVAILABLE;
    if (!is_gone && is_exhaustion(error.err())) rethrow(doing.c_str(), error);
    throw Error(ErrorKind::no_device,
                fmt::format("while {}: the driver refuses ({})", doing, status_text(error)));
  }
}

std::string build_options(int lanes) {
  if (lanes != 1 && lanes != 4 && lanes != 8 && lanes != 16) {
    throw Error(ErrorKind::usage, fmt::format("{} lanes: expected 1, 4, 8 or 16", lanes));
  }
  // -w turns warnings off, because a driver would print its own on the user's terminal.
  // `scripts/lint kernels` shows the warnings.
  return fmt::format("-cl-std=CL1.2 -w -DLANES={}", lanes);
}

Program::Program(const Context& context, const SourceTree& sources, const std::string& entry,
                 int lanes, const std::vector<std::string>& defines)
    : device_(fmt::format("{} {} (driver {})", context.device().selector(), context.device().name,
                          context.device().driver)),
      entry_(described(entry)),
      lanes_(lanes) {
  const auto options = options_with(lanes, defines);
  const auto text = flatten(sources, entry);
  if (!keeps_binaries(context.device().platform)) {
    build(context, text, options);
    return;
  }
  const auto store = BinaryStore::of_user();
  const auto key = binary_key(context.device(), text, options);
  if (const auto kept = store.find(key); kept && take_binary(context, *kept, options)) return;
  build(context, text, options);
  store.keep(key, binary());
}

void Program::build(const Context& context, const std::string& text, const std::string& options) {
  const auto doing = fmt::format("building the kernels of {}", entry_);
  guarded(doing.c_str(), [&] {
    program_ = std::make_shared<cl::Program>(context.handle(), text);
    const cl::Device& device = *context.device().handle;
    // The bindings' own build() would lose the status if the driver gives no log.
    const cl_device_id id = device();
    const cl_int status =
        ::clBuildProgram((*program_)(), 1, &id, options.c_str(), nullptr, nullptr);
    if (status == CL_SUCCESS) return;
    if (is_exhaustion(status)) throw cl::Error(status, "clBuildProgram");
    throw_build_error(context.device(), entry_, options, status, build_log(*program_, device));
  });
}

/// Returns whether the driver accepts the binary. A refusal is not an error, because the program
/// can be built from its text.
bool Program::take_binary(const Context& context, const std::string& binary,
                          const std::string& options) {
  try {
    const std::vector<unsigned char> bytes(binary.begin(), binary.end());
    const std::vector<cl::Device> devices{*context.device().handle};
    program_ =
        std::make_shared<cl::Program>(context.handle(), devices, cl::Program::Binaries{bytes});
    program_->build(devices, options.c_str());
    return true;
  } catch (const cl::Error&) {
    return false;
  }
}

/// Returns the machine code of the program, or an empty string if the driver provides none.
std::string Program::binary() const {
  try {
    const auto binaries = program_->getInfo<CL_PROGRAM_BINARIES>();
    if (binaries.size() != 1) return {};
    return {binaries.front().begin(), binaries.front().end()};
  } catch (const cl::Error&) {
    return {};
  }
}

Kernel Program::kernel(const std::string& name) const {
  try {
    return std::make_shared<cl::Kernel>(*program_, name.c_str());
  } catch (const cl::Error& error) {
    rethrow(fmt::format("making the kernel {} of {} on {}", name, entry_, device_).c_str(), error);
  }
}

}  // namespace aerostat::opencl
