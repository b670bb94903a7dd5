// Step 6 adds sun, shadows and Phong shading. See docs/tutorial/6-light.md.
#include <iostream>
#include <numeric>

#include "tutorial.hpp"

using namespace tutorial;

int main(int argc, char** argv) {
  const int width = 640, height = 360, pixels = width * height;
  const Camera camera = look_at({0.1f, 0.42f, 1.4f}, {0.0f, 0.12f, 0.0f}, 42.0f, width, height);

  // One tree holds the ground and the balloon. No hill is higher than 0.25, so that a hit above
  // 0.3 is on the balloon.
  std::vector<Triangle> triangles = hills(160);
  const std::vector<Triangle> balloon = sphere({0.28f, 0.42f, 0.1f}, 0.11f, 24);
  triangles.insert(triangles.end(), balloon.begin(), balloon.end());
  const std::vector<Node> nodes = build_tree(triangles);

  const Device device;
  const cl::Program program = device.build({"rays.clh", "traverse_tree.clh", "step6_light.cl"});
  const cl::Buffer picture = device.allocate<std::uint8_t>(3 * pixels);
  const cl::Buffer shadow_buffer = device.allocate<cl_uint>(pixels);
  device.run(kernel_with(program, "render", camera, device.upload(nodes), device.upload(triangles),
                         cl_float{0.3f}, picture, shadow_buffer),
             width, height);
  const auto rgb = device.download<std::uint8_t>(picture, 3 * pixels);
  const auto shadows = device.download<cl_uint>(shadow_buffer, pixels);
  const double share = std::accumulate(shadows.begin(), shadows.end(), 0.0) / (4.0 * pixels);
  std::cout << 100.0 * share << " % of the samples are in shadow\n";
  check(share > 0.02 && share < 0.5, "some of the land is in shadow, and not all");
  write_png(output_path(argc, argv, "step6.png"), width, height, rgb);
  return failed_checks();
}
