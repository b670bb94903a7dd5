#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"
#include "mesh/export.hpp"

namespace aerostat::mesh {
namespace {

// The longest line has six floats such as -1.17549435e-38 or six numbers of ten digits.
constexpr std::size_t kLongestLine = 112;
constexpr std::size_t kTypicalLine = 48;

/// Builds one line in a buffer of its own and appends it, so that no memory is allocated for a
/// number.
class LineWriter {
 public:
  explicit LineWriter(std::vector<std::uint8_t>& text) : text_(text) {}

  void vector(const char* keyword, const vec3& v) { finish(numbers(word(line_, keyword), v)); }

  void vectors(const char* keyword, const vec3& a, const vec3& b) {
    finish(numbers(numbers(word(line_, keyword), a), b));
  }

  void face(const uvec3& triangle, std::uint32_t first) {
    char* out = word(line_, "f");
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t index = triangle[corner] + first;
      *out++ = ' ';
      out = std::to_chars(out, line_ + kLongestLine, index).ptr;
      out = word(out, "//");
      out = std::to_chars(out, line_ + kLongestLine, index).ptr;
    }
    finish(out);
  }

 private:
  char* numbers(char* out, const vec3& v) {
    for (int axis = 0; axis < 3; ++axis) {
      *out++ = ' ';
      out = std::to_chars(out, line_ + kLongestLine, v[axis]).ptr;
    }
    return out;
  }

  static char* word(char* out, const char* text) {
    while (*text != '\0') *out++ = *text++;
    return out;
  }

  void finish(char* out) {
    *out++ = '\n';
    text_.insert(text_.end(), line_, out);
  }

  std::vector<std::uint8_t>& text_;
  char line_[kLongestLine + 1] = {};
};

std::size_t count_lines(std::span<const ExportObject> objects) {
  std::size_t vertices = 0;
  std::size_t lines = 0;
  for (const ExportObject& object : objects) {
    check(*object.mesh, object.name.c_str());
    vertices += object.mesh->positions.size();
    lines += 2 * object.mesh->positions.size() + object.mesh->triangles.size() + 1;
  }
  if (vertices > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw Error(
        ErrorKind::internal,
        fmt::format("exporting OBJ: {} vertices, at most 2147483647 can be numbered", vertices));
  }
  return lines;
}

void add(std::vector<std::uint8_t>& text, std::string_view line) {
  text.insert(text.end(), line.begin(), line.end());
}

void add_vertices(const ExportObject& object, bool colored, LineWriter& line) {
  const TriangleMesh& mesh = *object.mesh;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (colored) {
      line.vectors("v", mesh.positions[i], vertex_color(object, i));
    } else {
      line.vector("v", mesh.positions[i]);
    }
  }
  for (const vec3& normal : mesh.normals) line.vector("vn", normal);
}

/// Colours times area, and area.
struct ColorSum {
  dvec3 color{0.0};
  double area = 0.0;
};

void add_colors(const ExportObject& object, ColorSum& sum) {
  const TriangleMesh& mesh = *object.mesh;
  for (const uvec3& t : mesh.triangles) {
    const vec3& a = mesh.positions[t.x];
    const dvec3 across(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a));
    const double area = glm::length(across);
    for (int corner = 0; corner < 3; ++corner) {
      sum.color += dvec3(vertex_color(object, t[corner])) * (area / 3.0);
    }
    sum.area += area;
  }
}

}  // namespace

std::vector<std::uint8_t> obj_bytes(std::span<const ExportObject> objects, const dvec3& origin,
                                    const std::string& library) {
  std::vector<std::uint8_t> text;
  text.reserve(kTypicalLine * (count_lines(objects) + 1));
  add(text, "# metres, right-handed, y up\n");
  if (const std::string from = origin_text(origin); !from.empty()) add(text, "# " + from + "\n");
  if (!library.empty()) add(text, "mtllib " + library + "\n");
  const bool colored = std::any_of(objects.begin(), objects.end(), is_colored);
  LineWriter line(text);
  std::uint32_t first = 1;
  for (const ExportObject& object : objects) {
    add(text, "o " + object.name + '\n');
    if (!object.material.empty()) add(text, "usemtl " + object.material + '\n');
    add_vertices(object, colored, line);
    for (const uvec3& triangle : object.mesh->triangles) line.face(triangle, first);
    first += static_cast<std::uint32_t>(object.mesh->positions.size());
  }
  return text;
}

std::vector<std::uint8_t> mtl_bytes(std::span<const ExportObject> objects) {
  std::map<std::string, ColorSum> sums;
  for (const ExportObject& object : objects) {
    if (!object.material.empty()) add_colors(object, sums[object.material]);
  }
  std::string text = "# mean colours, linear Rec. 709\n";
  for (const auto& [name, sum] : sums) {
    const dvec3 mean = sum.area > 0.0 ? sum.color / sum.area : dvec3(0.0);
    text +=
        fmt::format("newmtl {}\nKd {:.6g} {:.6g} {:.6g}\nillum 1\n", name, mean.x, mean.y, mean.z);
  }
  return {text.begin(), text.end()};
}

}  // namespace aerostat::mesh
