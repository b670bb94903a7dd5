#include "opencl/launch.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "opencl/status.hpp"

namespace aerostat::opencl {
namespace {

std::string name_of(const cl::Kernel& kernel) {
  try {
    return kernel.getInfo<CL_KERNEL_FUNCTION_NAME>();
  } catch (const cl::Error&) {
    return "(unknown)";
  }
}

/// Waits for `event`. A driver reports only that something failed, so this throws the status of the
/// command itself if it has one.
void wait_for(const cl::Event& event) {
  try {
    event.wait();
  } catch (const cl::Error& error) {
    const int own = event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>();
    if (own < 0) throw cl::Error(own, "the kernel");
    throw;
  }
}

}  // namespace

std::size_t dividing_group_size(std::size_t global, std::size_t wanted) {
  if (wanted == 0 || global == 0) return 0;
  std::size_t size = std::min(wanted, global);
  while (global % size != 0) --size;
  return size;
}

void set_argument(const Kernel& kernel, unsigned index, const void* value, std::size_t bytes) {
  try {
    kernel->setArg(index, bytes, value);
  } catch (const cl::Error& error) {
    rethrow(fmt::format("setting argument {} of the kernel {}", index, name_of(*kernel)).c_str(),
            error);
  }
}

void set_argument(const Kernel& kernel, unsigned index, const RawBuffer& buffer) {
  const cl_mem handle = buffer.handle() != nullptr ? (*buffer.handle())() : nullptr;
  set_argument(kernel, index, &handle, sizeof(handle));
}

Event enqueue(const Context& context, const Kernel& kernel, const LaunchSize& size) {
  if (size.global == 0) return nullptr;
  auto event = std::make_shared<cl::Event>();
  const auto local = dividing_group_size(size.global, size.local);
  try {
    context.queue()->enqueueNDRangeKernel(
        *kernel, cl::NDRange(size.offset), cl::NDRange(size.global),
        local == 0 ? cl::NullRange : cl::NDRange(local), nullptr, event.get());
    context.queue()->flush();
  } catch (const cl::Error& error) {
    rethrow(fmt::format("starting the kernel {}", name_of(*kernel)).c_str(), error);
  }
  return event;
}

double device_seconds(const Event& event) {
  if (!event) return 0.0;
  return guarded("waiting for a kernel", [&] {
    wait_for(*event);
    const auto start = event->getProfilingInfo<CL_PROFILING_COMMAND_START>();
    const auto end = event->getProfilingInfo<CL_PROFILING_COMMAND_END>();
    return end > start ? static_cast<double>(end - start) * 1e-9 : 0.0;
  });
}

void finish(const Context& context) {
  guarded("waiting for the device", [&] { context.queue()->finish(); });
}

}  // namespace aerostat::opencl
