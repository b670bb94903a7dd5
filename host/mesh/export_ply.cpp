#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "mesh/export.hpp"

namespace aerostat::mesh {
namespace {

static_assert(std::endian::native == std::endian::little, "the writer copies words as they lie");

constexpr std::size_t kVertexBytes = 6 * sizeof(float);
constexpr std::size_t kColorBytes = 3 + sizeof(vec3);
constexpr std::size_t kFaceBytes = 1 + 4 * sizeof(std::uint32_t);

struct Totals {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  bool colored = false;
};

Totals measure(std::span<const ExportObject> objects) {
  Totals totals;
  for (const ExportObject& object : objects) {
    check(*object.mesh, object.name.c_str());
    totals.vertices += object.mesh->positions.size();
    totals.triangles += object.mesh->triangles.size();
    totals.colored = totals.colored || is_colored(object);
  }
  if (totals.vertices > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw Error(ErrorKind::internal,
                fmt::format("exporting PLY: {} vertices, at most 2147483647 can be numbered",
                            totals.vertices));
  }
  return totals;
}

std::string header(const Totals& totals, const std::string& origin) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment metres, right-handed, y up\n{}"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n{}"
      "element face {}\nproperty list uchar int vertex_indices\nproperty uint object_id\n"
      "end_header\n",
      origin.empty() ? "" : "comment " + origin + "\n", totals.vertices,
      totals.colored ? "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                       "property float r\nproperty float g\nproperty float b\n"
                     : "",
      totals.triangles);
}

std::uint8_t srgb_byte(float linear) {
  const float x = std::clamp(linear, 0.0f, 1.0f);
  const float encoded = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
  return static_cast<std::uint8_t>(std::lround(255.0f * encoded));
}

std::uint8_t* put(std::uint8_t* out, const void* data, std::size_t size) {
  std::memcpy(out, data, size);
  return out + size;
}

std::uint8_t* put_vertices(std::uint8_t* out, const ExportObject& object, bool colored) {
  static_assert(sizeof(vec3) == 3 * sizeof(float));
  const TriangleMesh& mesh = *object.mesh;
  vec3 last_color(1.0f);
  std::uint8_t rgb[3] = {255, 255, 255};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    out = put(out, &mesh.positions[i], sizeof(vec3));
    out = put(out, &mesh.normals[i], sizeof(vec3));
    if (!colored) continue;
    const vec3 color = vertex_color(object, i);
    if (color != last_color) {
      for (int channel = 0; channel < 3; ++channel) rgb[channel] = srgb_byte(color[channel]);
      last_color = color;
    }
    out = put(out, rgb, sizeof rgb);
    out = put(out, &color, sizeof color);
  }
  return out;
}

std::uint8_t* put_faces(std::uint8_t* out, const ExportObject& object, std::uint32_t first_vertex) {
  for (const uvec3& triangle : object.mesh->triangles) {
    const std::uint32_t words[4] = {triangle.x + first_vertex, triangle.y + first_vertex,
                                    triangle.z + first_vertex, object.id};
    *out++ = 3;
    out = put(out, words, sizeof words);
  }
  return out;
}

}  // namespace

bool is_colored(const ExportObject& object) {
  return !object.mesh->colors.empty() || object.color != vec3(1.0f);
}

vec3 vertex_color(const ExportObject& object, std::size_t vertex) {
  return object.mesh->colors.empty() ? object.color : object.color * object.mesh->colors[vertex];
}

std::string origin_text(const dvec3& origin) {
  if (origin == dvec3(0.0)) return {};
  return fmt::format("origin {} {} {}", origin.x, origin.y, origin.z);
}

std::vector<std::uint8_t> ply_bytes(std::span<const ExportObject> objects, const dvec3& origin) {
  const Totals totals = measure(objects);
  const std::string head = header(totals, origin_text(origin));
  const std::size_t vertex_bytes = kVertexBytes + (totals.colored ? kColorBytes : 0);
  std::vector<std::uint8_t> bytes(head.size() + totals.vertices * vertex_bytes +
                                  totals.triangles * kFaceBytes);
  std::uint8_t* out = put(bytes.data(), head.data(), head.size());
  for (const ExportObject& object : objects) {
    out = put_vertices(out, object, totals.colored);
  }
  std::uint32_t first_vertex = 0;
  for (const ExportObject& object : objects) {
    out = put_faces(out, object, first_vertex);
    first_vertex += static_cast<std::uint32_t>(object.mesh->positions.size());
  }
  return bytes;
}

}  // namespace aerostat::mesh
