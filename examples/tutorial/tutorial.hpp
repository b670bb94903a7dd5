#pragma once

// This header holds what all steps of the tutorial share: opening a device, building a program
// from its text, small vectors, a camera, two meshes, a tree and a PNG writer. The ray tracing
// itself is in the .cl files, which are the place to look first.

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_TARGET_OPENCL_VERSION 120
#pragma GCC system_header  // the bindings of OpenCL cause warnings

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <CL/opencl.hpp>

namespace tutorial {

using Vec3 = std::array<float, 3>;

Vec3 operator+(Vec3 a, Vec3 b);
Vec3 operator-(Vec3 a, Vec3 b);
Vec3 operator*(Vec3 a, float s);
float dot(Vec3 a, Vec3 b);
Vec3 cross(Vec3 a, Vec3 b);
Vec3 normalize(Vec3 a);

/// A triangle. rays.clh has the same structs. They have only 32-bit members, so that both sides
/// agree on the layout.
struct Triangle {
  Vec3 v0, v1, v2;
};
static_assert(sizeof(Triangle) == 36);

/// A pinhole camera. The ray through the picture's point (x, y), both from -1 to 1, has the
/// direction forward + x * right + y * up.
struct Camera {
  Vec3 eye, right, up, forward;
};
static_assert(sizeof(Camera) == 48);

Camera look_at(Vec3 eye, Vec3 target, float fov_y_deg, int width, int height);

/// A node of a bounding volume hierarchy. A leaf has `count` triangles from `first` on. An inner
/// node has a count of 0, and its two children are the nodes `first` and `first` + 1.
struct Node {
  Vec3 low, high;
  std::uint32_t first, count;
};
static_assert(sizeof(Node) == 32);

/// The nearest triangle that a ray meets, from step 3 on. `triangle` is ~0 if there is none.
struct Hit {
  float t, u, v;
  std::uint32_t triangle;
};
static_assert(sizeof(Hit) == 16);

/// How many boxes and triangles were tested for a ray or a packet, from step 3 on.
struct Work {
  std::uint32_t boxes, triangles;
};
static_assert(sizeof(Work) == 8);

/// Builds a tree by splitting at the median along the longest axis. Reorders the triangles.
std::vector<Node> build_tree(std::vector<Triangle>& triangles);

/// Returns hills over a square of 2 x 2 with `cells` x `cells` cells of two triangles each. y
/// points up.
std::vector<Triangle> hills(int cells);
/// Returns a closed sphere of 2 * rings * (2 * rings - 2) triangles.
std::vector<Triangle> sphere(Vec3 center, float radius, int rings);

/// The first CPU device of the machine, or the first device of any kind.
class Device {
 public:
  Device();
  /// Joins the files of examples/tutorial to one program and compiles it. If it does not compile,
  /// prints the compiler's messages and throws cl::Error.
  cl::Program build(const std::vector<std::string>& files, const std::string& options = "") const;

  template <typename Item>
  cl::Buffer upload(const std::vector<Item>& items) const {
    return cl::Buffer(context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, items.size() * sizeof(Item),
                      const_cast<Item*>(items.data()));
  }
  template <typename Item>
  cl::Buffer allocate(std::size_t count) const {
    return cl::Buffer(context, CL_MEM_READ_WRITE, count * sizeof(Item));
  }
  template <typename Item>
  std::vector<Item> download(const cl::Buffer& buffer, std::size_t count) const {
    std::vector<Item> items(count);
    queue.enqueueReadBuffer(buffer, CL_TRUE, 0, count * sizeof(Item), items.data());
    return items;
  }
  /// Runs a kernel over columns x rows work-items, waits for it, and returns the seconds that it
  /// took.
  double run(const cl::Kernel& kernel, int columns, int rows) const;

  cl::Context context;
  cl::CommandQueue queue;
};

/// Makes a kernel and sets its arguments in their order.
template <typename... Arguments>
cl::Kernel kernel_with(const cl::Program& program, const char* name,
                       const Arguments&... arguments) {
  cl::Kernel kernel(program, name);
  cl_uint index = 0;
  (kernel.setArg(index++, arguments), ...);
  return kernel;
}

/// Writes a picture of 3 bytes for each pixel, with row 0 at the top. Throws std::runtime_error
/// if that fails.
void write_png(const std::string& path, int width, int height,
               const std::vector<std::uint8_t>& rgb);

/// Prints what was checked and whether it holds.
void check(bool holds, const std::string& what);
/// Returns the number of checks that failed. It is the exit code of a step, so that the tests can
/// run it.
int failed_checks();

/// Returns the path of a step's picture, in the folder named on the command line or in the
/// current one.
std::string output_path(int argc, char** argv, const std::string& name);

}  // namespace tutorial
