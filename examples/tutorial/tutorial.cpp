#include "tutorial.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <utility>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace tutorial {
namespace {

int failures = 0;

std::string read_text(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

cl::Device find_device() {
  std::vector<cl::Platform> platforms;
  cl::Platform::get(&platforms);
  for (const cl_device_type type :
       {cl_device_type{CL_DEVICE_TYPE_CPU}, cl_device_type{CL_DEVICE_TYPE_ALL}}) {
    for (const cl::Platform& platform : platforms) {
      std::vector<cl::Device> devices;
      try {
        platform.getDevices(type, &devices);
      } catch (const cl::Error&) {
        continue;  // the platform has no such device
      }
      if (!devices.empty()) return devices.front();
    }
  }
  throw std::runtime_error("no OpenCL device found; install pocl-opencl-icd");
}

void add_quad(std::vector<Triangle>& triangles, Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  triangles.push_back({a, b, c});
  triangles.push_back({a, c, d});
}

float center_along(const Triangle& triangle, std::size_t axis) {
  return (triangle.v0[axis] + triangle.v1[axis] + triangle.v2[axis]) / 3.0f;
}

void grow_box(Node& node, const Triangle& triangle) {
  for (const Vec3& v : {triangle.v0, triangle.v1, triangle.v2}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.low[axis] = std::min(node.low[axis], v[axis]);
      node.high[axis] = std::max(node.high[axis], v[axis]);
    }
  }
}

constexpr std::uint32_t kLeafTriangles = 4;

void split(std::vector<Node>& nodes, std::size_t index, std::vector<Triangle>& triangles) {
  const Node node = nodes[index];
  if (node.count <= kLeafTriangles) return;
  const Vec3 size = node.high - node.low;
  const auto axis =
      static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  const std::uint32_t half = node.count / 2;
  const auto begin = triangles.begin() + node.first;
  std::nth_element(begin, begin + half, begin + node.count,
                   [axis](const Triangle& a, const Triangle& b) {
                     return center_along(a, axis) < center_along(b, axis);
                   });
  const auto left = static_cast<std::uint32_t>(nodes.size());
  for (const auto& [first, count] :
       {std::pair{node.first, half}, std::pair{node.first + half, node.count - half}}) {
    Node child{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, first, count};
    for (std::uint32_t i = 0; i < count; ++i) grow_box(child, triangles[first + i]);
    nodes.push_back(child);
  }
  nodes[index].first = left;
  nodes[index].count = 0;
  split(nodes, left, triangles);
  split(nodes, left + 1, triangles);
}

}  // namespace

Vec3 operator+(Vec3 a, Vec3 b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vec3 operator-(Vec3 a, Vec3 b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vec3 operator*(Vec3 a, float s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}
float dot(Vec3 a, Vec3 b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec3 cross(Vec3 a, Vec3 b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec3 normalize(Vec3 a) {
  return a * (1.0f / std::sqrt(dot(a, a)));
}

Camera look_at(Vec3 eye, Vec3 target, float fov_y_deg, int width, int height) {
  const float half_height = std::tan(fov_y_deg * 3.14159265f / 360.0f);
  const Vec3 forward = normalize(target - eye);
  const Vec3 right = normalize(cross(forward, {0.0f, 1.0f, 0.0f}));
  const Vec3 up = cross(right, forward);
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  return {eye, right * (half_height * aspect), up * half_height, forward};
}

std::vector<Node> build_tree(std::vector<Triangle>& triangles) {
  Node root{{INFINITY, INFINITY, INFINITY},
            {-INFINITY, -INFINITY, -INFINITY},
            0,
            static_cast<std::uint32_t>(triangles.size())};
  for (const Triangle& triangle : triangles) grow_box(root, triangle);
  std::vector<Node> nodes{root};
  split(nodes, 0, triangles);
  return nodes;
}

std::vector<Triangle> hills(int cells) {
  const auto point = [cells](int column, int row) -> Vec3 {
    const float x = 2.0f * static_cast<float>(column) / static_cast<float>(cells) - 1.0f;
    const float z = 2.0f * static_cast<float>(row) / static_cast<float>(cells) - 1.0f;
    const float y = 0.16f * std::sin(3.1f * x + 1.3f) * std::cos(2.7f * z) +
                    0.07f * std::sin(7.3f * x - 4.1f * z) + 0.02f * std::sin(19.0f * z + 11.0f * x);
    return {x, y, z};
  };
  std::vector<Triangle> triangles;
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      add_quad(triangles, point(column, row), point(column, row + 1), point(column + 1, row + 1),
               point(column + 1, row));
    }
  }
  return triangles;
}

std::vector<Triangle> sphere(Vec3 center, float radius, int rings) {
  // Every corner is computed once and shared by the triangles around it, because a closed mesh
  // must have no gaps.
  const int columns = 2 * rings;
  std::vector<std::vector<Vec3>> points;
  for (int ring = 0; ring <= rings; ++ring) {
    const bool is_pole = ring == 0 || ring == rings;
    const float polar = 3.14159265f * static_cast<float>(ring) / static_cast<float>(rings);
    const float around = is_pole ? 0.0f : std::sin(polar);
    std::vector<Vec3>& row = points.emplace_back();
    for (int column = 0; column < columns; ++column) {
      const float angle = 6.2831853f * static_cast<float>(column) / static_cast<float>(columns);
      row.push_back(center +
                    Vec3{around * std::cos(angle), std::cos(polar), around * std::sin(angle)} *
                        radius);
    }
  }
  std::vector<Triangle> triangles;
  for (std::size_t ring = 0; ring < static_cast<std::size_t>(rings); ++ring) {
    for (std::size_t column = 0; column < static_cast<std::size_t>(columns); ++column) {
      const std::size_t next = (column + 1) % static_cast<std::size_t>(columns);
      const Vec3 a = points[ring][column], b = points[ring + 1][column];
      const Vec3 c = points[ring + 1][next], d = points[ring][next];
      if (ring + 1 < static_cast<std::size_t>(rings)) triangles.push_back({a, c, b});
      if (ring > 0) triangles.push_back({a, d, c});
    }
  }
  return triangles;
}

Device::Device() {
  const cl::Device device = find_device();
  context = cl::Context(device);
  queue = cl::CommandQueue(context, device);
  std::cout << "device: " << device.getInfo<CL_DEVICE_NAME>() << '\n';
}

cl::Program Device::build(const std::vector<std::string>& files, const std::string& options) const {
  cl::Program::Sources texts;
  for (const std::string& file : files) texts.push_back(read_text(TUTORIAL_FOLDER "/" + file));
  cl::Program program(context, texts);
  try {
    program.build(("-cl-std=CL1.2 " + options).c_str());
  } catch (const cl::Error&) {
    for (const auto& [device, log] : program.getBuildInfo<CL_PROGRAM_BUILD_LOG>()) {
      std::cerr << log << '\n';
    }
    throw;
  }
  return program;
}

double Device::run(const cl::Kernel& kernel, int columns, int rows) const {
  const auto start = std::chrono::steady_clock::now();
  queue.enqueueNDRangeKernel(
      kernel, cl::NullRange,
      cl::NDRange(static_cast<std::size_t>(columns), static_cast<std::size_t>(rows)));
  queue.finish();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void write_png(const std::string& path, int width, int height,
               const std::vector<std::uint8_t>& rgb) {
  if (stbi_write_png(path.c_str(), width, height, 3, rgb.data(), 3 * width) == 0) {
    throw std::runtime_error("cannot write " + path);
  }
  std::cout << "wrote " << path << '\n';
}

void check(bool holds, const std::string& what) {
  std::cout << (holds ? "holds: " : "DOES NOT HOLD: ") << what << '\n';
  if (!holds) ++failures;
}

int failed_checks() {
  return failures;
}

std::string output_path(int argc, char** argv, const std::string& name) {
  return (argc > 1 ? std::string(argv[1]) + "/" : std::string()) + name;
}

}  // namespace tutorial
