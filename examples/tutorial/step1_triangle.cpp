// Step 1 traces one ray for each pixel and intersects it with one triangle. See
// docs/tutorial/1-triangle.md.
#include <cmath>
#include <iostream>

#include "tutorial.hpp"

using namespace tutorial;

namespace {

// Returns the triangle's area in pixels, computed from the places of its corners in the picture.
double area_in_pixels(const Camera& camera, const Triangle& triangle, int width, int height) {
  const auto place = [&](Vec3 corner) {
    const Vec3 ray = corner - camera.eye;
    const float depth = dot(ray, camera.forward);
    const float x = dot(ray, camera.right) / dot(camera.right, camera.right) / depth;
    const float y = dot(ray, camera.up) / dot(camera.up, camera.up) / depth;
    return Vec3{x * static_cast<float>(width) / 2.0f, y * static_cast<float>(height) / 2.0f, 0.0f};
  };
  const Vec3 a = place(triangle.v0), b = place(triangle.v1), c = place(triangle.v2);
  return std::abs(cross(b - a, c - a)[2]) / 2.0;
}

}  // namespace

int main(int argc, char** argv) {
  const int width = 320, height = 180;
  const Camera camera = look_at({0.0f, 0.4f, 3.0f}, {0.0f, 0.2f, 0.0f}, 40.0f, width, height);
  const Triangle triangle{{-1.0f, -0.5f, 0.0f}, {1.0f, -0.3f, 0.4f}, {0.1f, 1.1f, -0.3f}};

  const Device device;
  const cl::Program program = device.build({"step1_triangle.cl"});
  const cl::Buffer picture = device.allocate<std::uint8_t>(3 * width * height);
  device.run(kernel_with(program, "draw_triangle", camera, triangle, picture), width, height);
  const auto rgb = device.download<std::uint8_t>(picture, 3 * width * height);

  // The weights of the corners add up to 1. Therefore the bytes of a pixel of the triangle add up
  // to 255, apart from the rounding of three bytes. Those of the background add up to 166.
  int inside = 0;
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    inside += std::abs(rgb[i] + rgb[i + 1] + rgb[i + 2] - 255) <= 2 ? 1 : 0;
  }
  const double area = area_in_pixels(camera, triangle, width, height);
  std::cout << inside << " pixels show the triangle, whose area is " << area << " pixels\n";
  check(std::abs(inside - area) < 0.01 * area, "as many pixels as the triangle's area");
  write_png(output_path(argc, argv, "step1.png"), width, height, rgb);
  return failed_checks();
}
