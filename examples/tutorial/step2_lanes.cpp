// Step 2 renders the same picture with one ray and with eight rays in a work-item. See
// docs/tutorial/2-lanes.md.
#include <cmath>
#include <cstring>
#include <iostream>

#include "tutorial.hpp"

using namespace tutorial;

int main(int argc, char** argv) {
  const int width = 320, height = 184, pixels = width * height;
  const Camera camera = look_at({0.0f, 0.9f, 3.0f}, {0.0f, 0.0f, 0.0f}, 40.0f, width, height);
  const std::vector<Triangle> triangles = sphere({0.0f, 0.0f, 0.0f}, 1.0f, 8);

  const Device device;
  const cl::Buffer triangle_buffer = device.upload(triangles);
  std::vector<float> depths[2];
  std::vector<cl_uint> hits[2];
  double seconds[2] = {};
  for (const int lanes : {1, 8}) {
    const std::size_t at = lanes == 1 ? 0 : 1;
    const cl::Program program =
        device.build({"step2_lanes.cl"}, "-DLANES=" + std::to_string(lanes));
    const cl::Buffer depth_buffer = device.allocate<float>(pixels);
    const cl::Buffer hit_buffer = device.allocate<cl_uint>(pixels);
    const cl::Kernel kernel =
        kernel_with(program, "trace_rows", camera, triangle_buffer,
                    static_cast<cl_int>(triangles.size()), cl_int{width}, depth_buffer, hit_buffer);
    device.run(kernel, width / lanes, height);  // compiles the kernel on some drivers
    seconds[at] = device.run(kernel, width / lanes, height);
    depths[at] = device.download<float>(depth_buffer, pixels);
    hits[at] = device.download<cl_uint>(hit_buffer, pixels);
    std::cout << lanes << " rays a work-item: " << 1e3 * seconds[at] << " ms\n";
  }

  std::vector<std::uint8_t> rgb;
  int inside = 0;
  for (std::size_t i = 0; i < hits[1].size(); ++i) {
    const bool hit = hits[1][i] != ~0u;
    inside += hit ? 1 : 0;
    for (const cl_uint factor : {37u, 71u, 113u}) {
      rgb.push_back(hit ? static_cast<std::uint8_t>(80 + hits[1][i] * factor % 160) : 40);
    }
  }
  check(inside > pixels / 8, "the sphere is in the picture");
  check(hits[0] == hits[1], "one and eight lanes meet the same triangles");
  check(std::memcmp(depths[0].data(), depths[1].data(), sizeof(float) * pixels) == 0,
        "one and eight lanes give the same bits");
  write_png(output_path(argc, argv, "step2.png"), width, height, rgb);
  return failed_checks();
}
