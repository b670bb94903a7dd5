// Step 5 lets 64 rays share their traversal of the tree. See docs/tutorial/5-packets.md.
#include <cstring>
#include <iostream>

#include "tutorial.hpp"

using namespace tutorial;

namespace {

constexpr int kSide = 8;

double boxes_of(const std::vector<Work>& works) {
  double boxes = 0.0;
  for (const Work& work : works) boxes += work.boxes;
  return boxes;
}

}  // namespace

int main(int argc, char** argv) {
  const int width = 640, height = 360, pixels = width * height;
  const Camera camera = look_at({0.0f, 0.55f, 1.5f}, {0.0f, 0.0f, 0.0f}, 45.0f, width, height);
  std::vector<Triangle> triangles = hills(96);
  const std::vector<Node> nodes = build_tree(triangles);

  const Device device;
  const cl::Program program =
      device.build({"rays.clh", "traverse_tree.clh", "step3_tree.cl", "step5_packets.cl"});
  const cl::Buffer triangle_buffer = device.upload(triangles);
  const cl::Buffer node_buffer = device.upload(nodes);
  const cl::Buffer lone_hits = device.allocate<Hit>(pixels);
  const cl::Buffer lone_works = device.allocate<Work>(pixels);
  const cl::Buffer packet_hits = device.allocate<Hit>(pixels);
  const int packets = pixels / (kSide * kSide);
  const cl::Buffer packet_works = device.allocate<Work>(packets);
  device.run(kernel_with(program, "trace_tree", camera, node_buffer, triangle_buffer, lone_hits,
                         lone_works),
             width, height);
  device.run(kernel_with(program, "trace_packets", camera, node_buffer, triangle_buffer,
                         cl_int{width}, cl_int{height}, packet_hits, packet_works),
             width / kSide, height / kSide);

  const auto lone = device.download<Hit>(lone_hits, pixels);
  const auto packet = device.download<Hit>(packet_hits, pixels);
  const double lone_boxes = boxes_of(device.download<Work>(lone_works, pixels));
  const double packet_boxes = boxes_of(device.download<Work>(packet_works, packets));
  std::cout << "boxes tested for a ray: " << lone_boxes / pixels << " alone, "
            << packet_boxes / pixels << " in packets of " << kSide * kSide << '\n';
  check(std::memcmp(lone.data(), packet.data(), sizeof(Hit) * lone.size()) == 0,
        "packets give the hits of lone rays, bit by bit");
  check(packet_boxes < 0.2 * lone_boxes, "with less than a fifth of the box tests");

  std::vector<std::uint8_t> rgb;
  for (const Hit& hit : packet) {
    const bool is_hit = hit.triangle != ~0u;
    for (const cl_uint factor : {37u, 71u, 113u}) {
      rgb.push_back(is_hit ? static_cast<std::uint8_t>(60 + hit.triangle * factor % 180) : 40);
    }
  }
  write_png(output_path(argc, argv, "step5.png"), width, height, rgb);
  return failed_checks();
}
