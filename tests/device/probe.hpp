#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/math.hpp"
#include "opencl/buffer.hpp"
#include "opencl/launch.hpp"
#include "opencl/program.hpp"

/// Runs probe kernels, which are thin adapters between scalar arrays and the lane functions under
/// test.
namespace aerostat::test {

/// Returns a context on the device that AEROSTAT_DEVICE names, or on the default one. Throws
/// Error{no_device}, so that a test without a device fails.
const opencl::Context& context();

/// Returns `count` rounded up to whole packets of the widest lane type.
std::size_t whole_packets(std::size_t count);

/// Returns three planes (all x, all y, all z), in the form in which probes read vectors. They are
/// padded to whole packets by repeating the last element.
std::vector<float> planes(const std::vector<vec3>& vectors);

/// Returns the values padded to whole packets by repeating the last element.
std::vector<float> padded(std::vector<float> values);

/// Returns element `i` of planes of vectors.
vec3 from_planes(const std::vector<float>& values, std::size_t i);

template <typename T>
opencl::Buffer<T> input(const std::vector<T>& values) {
  return {context(), {}, std::span<const T>(values), "a probe's input"};
}

template <typename T>
opencl::Buffer<T> output(std::size_t count) {
  return {context(), {}, count, "a probe's output"};
}

/// A program of tests/device/probes at one lane width. It is built by the product's own class with
/// the product's own options and headers, once in a process.
class Probe {
 public:
  /// Builds the program of the file `name` in tests/device/probes, unless it is built already.
  Probe(const std::string& name, int lanes);

  int lanes() const { return program_->lanes(); }

  /// Runs `kernel` over `elements` scalar elements (whole packets), with one packet per work-item,
  /// and waits for it.
  template <typename... Args>
  void run(const char* kernel, std::size_t elements, const Args&... args) const {
    run_items(kernel, elements / static_cast<std::size_t>(lanes()), args...);
  }

  /// Runs `kernel` with `items` work-items and waits for it.
  template <typename... Args>
  void run_items(const char* kernel, std::size_t items, const Args&... args) const {
    const opencl::Kernel entry = program_->kernel(kernel);
    // All launches have the same group size, because PoCL compiles a kernel again for each size.
    opencl::launch(context(), entry, {items, 1}, args...);
    opencl::finish(context());
  }

 private:
  const opencl::Program* program_;
};

/// A test that runs at every lane width.
class LaneTest : public testing::TestWithParam<int> {};

#define AEROSTAT_AT_EVERY_WIDTH(fixture)                                 \
  INSTANTIATE_TEST_SUITE_P(Lanes, fixture, testing::Values(1, 4, 8, 16), \
                           testing::PrintToStringParamName())

}  // namespace aerostat::test
