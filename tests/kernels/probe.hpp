#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/math.hpp"
#include "opencl/buffer.hpp"
#include "opencl/launch.hpp"
#include "opencl/program.hpp"

/// Runs probe kernels: thin adapters between scalar arrays and the lane functions under test.
namespace aerostat::test {

/// The device that AEROSTAT_DEVICE names or the default one. Throws Error{no_device}: a test
/// without a device fails.
const opencl::Context& context();

/// `count` rounded up to whole packets of the widest lane type.
std::size_t whole_packets(std::size_t count);

/// Three planes (all x, all y, all z), as probes read vectors; padded to whole packets by
/// repeating the last element.
std::vector<float> planes(const std::vector<vec3>& vectors);

/// Padded likewise.
std::vector<float> padded(std::vector<float> values);

/// Element `i` of planes that hold `count` vectors.
vec3 from_planes(const std::vector<float>& values, std::size_t i);

template <typename T>
opencl::Buffer<T> input(const std::vector<T>& values) {
  return {context(), {}, std::span<const T>(values), "a probe's input"};
}

template <typename T>
opencl::Buffer<T> output(std::size_t count) {
  return {context(), {}, count, "a probe's output"};
}

/// A program of tests/kernels/probes at one lane width, built by the product's own class with the
/// product's own options and headers. Built once in a process.
class Probe {
 public:
  /// `name` is a file of tests/kernels/probes.
  Probe(const std::string& name, int lanes);

  int lanes() const { return program_->lanes(); }

  /// Runs `kernel` over `elements` scalar elements (whole packets), one packet a work-item, and
  /// waits for it.
  template <typename... Args>
  void run(const char* kernel, std::size_t elements, const Args&... args) const {
    run_items(kernel, elements / static_cast<std::size_t>(lanes()), args...);
  }

  /// Runs `kernel` with `items` work-items.
  template <typename... Args>
  void run_items(const char* kernel, std::size_t items, const Args&... args) const {
    const opencl::Kernel entry = program_->kernel(kernel);
    // One group size for all launches: PoCL compiles a kernel anew for each.
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
