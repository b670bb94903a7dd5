// Step 4 shows that no ray slips between two triangles that share an edge. See
// docs/tutorial/4-watertight.md.
#include <iostream>
#include <numeric>
#include <random>

#include "tutorial.hpp"

using namespace tutorial;

int main() {
  const int count = 100000;
  const Vec3 center{3.1f, -1.7f, 0.9f};
  const std::vector<Triangle> triangles = sphere(center, 1.0f, 12);

  // Each ray begins near the middle and aims at a point of some edge or at a corner.
  std::mt19937 random(1);
  std::uniform_real_distribution<float> share(0.0f, 1.0f);
  std::uniform_int_distribution<std::size_t> any(0, triangles.size() - 1);
  std::vector<float> origins, targets;
  for (int i = 0; i < count; ++i) {
    const Vec3 origin =
        center + Vec3{share(random) - 0.5f, share(random) - 0.5f, share(random) - 0.5f};
    const Triangle& triangle = triangles[any(random)];
    const float along = i % 4 == 0 ? 0.0f : share(random);
    const Vec3 target = triangle.v0 + (triangle.v1 - triangle.v0) * along;
    origins.insert(origins.end(), origin.begin(), origin.end());
    targets.insert(targets.end(), target.begin(), target.end());
  }

  const Device device;
  const cl::Program program = device.build({"rays.clh", "step4_watertight.cl"});
  const cl::Buffer by_edges = device.allocate<cl_uint>(count);
  const cl::Buffer by_woop = device.allocate<cl_uint>(count);
  device.run(kernel_with(program, "shoot_at_edges", device.upload(triangles),
                         static_cast<cl_uint>(triangles.size()), device.upload(origins),
                         device.upload(targets), by_edges, by_woop),
             count, 1);
  const auto escaped = [&](const cl::Buffer& buffer) {
    const auto flags = device.download<cl_uint>(buffer, count);
    return std::accumulate(flags.begin(), flags.end(), 0u);
  };
  const cl_uint leaks_by_edges = escaped(by_edges), leaks_by_woop = escaped(by_woop);
  std::cout << "of " << count << " rays " << leaks_by_edges << " leak by the test of step 1, "
            << leaks_by_woop << " by the watertight one\n";
  check(leaks_by_edges > 0, "the test of step 1 leaks");
  check(leaks_by_woop == 0, "the watertight test does not");
  return failed_checks();
}
