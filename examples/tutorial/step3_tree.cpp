// Step 3 uses a bounding volume hierarchy. See docs/tutorial/3-tree.md.
#include <algorithm>
#include <cstring>
#include <iostream>

#include "tutorial.hpp"

using namespace tutorial;

int main(int argc, char** argv) {
  const int width = 240, height = 136, pixels = width * height;
  const Camera camera = look_at({0.0f, 0.55f, 1.5f}, {0.0f, 0.0f, 0.0f}, 45.0f, width, height);
  std::vector<Triangle> triangles = hills(24);
  const std::vector<Node> nodes = build_tree(triangles);
  std::cout << triangles.size() << " triangles, " << nodes.size() << " nodes\n";

  const Device device;
  const cl::Program program = device.build({"rays.clh", "traverse_tree.clh", "step3_tree.cl"});
  const cl::Buffer triangle_buffer = device.upload(triangles);
  const cl::Buffer node_buffer = device.upload(nodes);
  const cl::Buffer all_buffer = device.allocate<Hit>(pixels);
  const cl::Buffer tree_buffer = device.allocate<Hit>(pixels);
  const cl::Buffer work_buffer = device.allocate<Work>(pixels);
  const cl::Kernel loop = kernel_with(program, "trace_all", camera, triangle_buffer,
                                      static_cast<cl_uint>(triangles.size()), all_buffer);
  const cl::Kernel traverse = kernel_with(program, "trace_tree", camera, node_buffer,
                                          triangle_buffer, tree_buffer, work_buffer);
  const double loop_seconds = device.run(loop, width, height);
  device.run(traverse, width, height);  // compiles the kernel on some drivers
  const double tree_seconds = device.run(traverse, width, height);
  std::cout << "all triangles: " << 1e3 * loop_seconds << " ms, tree: " << 1e3 * tree_seconds
            << " ms\n";

  const auto all = device.download<Hit>(all_buffer, pixels);
  const auto tree = device.download<Hit>(tree_buffer, pixels);
  const auto works = device.download<Work>(work_buffer, pixels);
  double boxes = 0.0, tested = 0.0;
  std::vector<std::uint8_t> rgb;
  for (const Work& work : works) {
    boxes += work.boxes;
    tested += work.triangles;
    // The picture shows the work of each ray: black for little, white for much.
    const cl_uint shade = std::min(255u, 2 * work.boxes + 4 * work.triangles);
    rgb.insert(rgb.end(), 3, static_cast<std::uint8_t>(shade));
  }
  std::cout << "a ray tests " << boxes / pixels << " boxes and " << tested / pixels
            << " triangles\n";
  check(std::memcmp(all.data(), tree.data(), sizeof(Hit) * all.size()) == 0,
        "the tree gives the hits of the loop, bit by bit");
  check(boxes + tested < 0.05 * pixels * static_cast<double>(triangles.size()),
        "with less than a twentieth of the tests");
  write_png(output_path(argc, argv, "step3.png"), width, height, rgb);
  return failed_checks();
}
