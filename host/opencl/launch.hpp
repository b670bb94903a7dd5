#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

#include "opencl/buffer.hpp"
#include "opencl/cl_names.hpp"

namespace aerostat::opencl {

/// A one-dimensional range of work-items. A plain number leaves the size of groups to the driver.
struct LaunchSize {
  std::size_t global = 0;
  /// The largest size of a group, or 0 to leave it to the driver.
  std::size_t local = 0;
  std::size_t offset = 0;

  LaunchSize(std::size_t global_items) : global(global_items) {}  // NOLINT: implicit on purpose
  LaunchSize(std::size_t global_items, std::size_t local_items, std::size_t first = 0)
      : global(global_items), local(local_items), offset(first) {}
};

/// Returns the largest group size up to `wanted` that divides `global`, as OpenCL 1.2 demands.
/// Returns 0 if `wanted` is 0.
std::size_t dividing_group_size(std::size_t global, std::size_t wanted);

/// A command that was enqueued, or null if there was nothing to do.
using Event = std::shared_ptr<const cl::Event>;

/// Enqueues `kernel` with its present arguments and flushes the queue, so that the device starts at
/// once. If the range is empty, nothing is launched and the event is null.
Event enqueue(const Context& context, const Kernel& kernel, const LaunchSize& size);

/// Waits for `event` and returns the seconds that its command ran by the device's own clock.
/// Returns 0 for a null event. Throws Error{exhausted} or Error{internal} if the command failed.
double device_seconds(const Event& event);

/// Waits for all commands that were enqueued.
void finish(const Context& context);

/// Sets argument `index` of `kernel`, counted from 0, to the `bytes` bytes at `value`, or to a
/// buffer. Throws Error{exhausted} or Error{internal} that names the kernel and the argument.
void set_argument(const Kernel& kernel, unsigned index, const void* value, std::size_t bytes);
void set_argument(const Kernel& kernel, unsigned index, const RawBuffer& buffer);

template <typename T>
void set_argument(const Kernel& kernel, unsigned index, const Buffer<T>& buffer) {
  set_argument(kernel, index, buffer.raw());
}

/// Sets an argument to a scalar or a shared struct by value. Types whose size differs between host
/// and device are refused.
template <typename T>
requires std::is_trivially_copyable_v<T>
void set_argument(const Kernel& kernel, unsigned index, const T& value) {
  static_assert(!std::is_pointer_v<T> && !std::is_same_v<T, bool>);
  static_assert(std::is_class_v<T> || sizeof(T) <= 4, "kernels know 32-bit scalars only");
  set_argument(kernel, index, &value, sizeof(T));
}

/// A kernel whose arguments have these types, in this order: `Buffer<T>`, 32-bit scalars and shared
/// structs. A launch with other types does not compile, so two buffers cannot be swapped.
template <typename... Args>
struct TypedKernel {
  Kernel kernel;
};

/// Sets all arguments of `kernel` (buffers, 32-bit scalars, shared structs) in their order. Then
/// enqueues it over `size` work-items on the context's in-order queue, without waiting. Throws
/// Error{exhausted} or Error{internal} with the kernel's name.
template <typename... Args>
Event launch(const Context& context, const Kernel& kernel, const LaunchSize& size,
             const Args&... args) {
  unsigned index = 0;
  (set_argument(kernel, index++, args), ...);
  return enqueue(context, kernel, size);
}

/// Does the same for a kernel that knows the types of its arguments.
template <typename... Args>
Event launch(const Context& context, const TypedKernel<Args...>& kernel, const LaunchSize& size,
             const std::type_identity_t<Args>&... args) {
  return launch(context, kernel.kernel, size, args...);
}

}  // namespace aerostat::opencl
