#include <charconv>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"
#include "mesh/export.hpp"

namespace aerostat::mesh {
namespace {

// The longest line has three floats such as -1.17549435e-38 or six numbers of ten digits.
constexpr std::size_t kLongestLine = 96;
constexpr std::size_t kTypicalLine = 40;

/// Builds one line in a buffer of its own and appends it, so that no memory is allocated for a
/// number.
class LineWriter {
 public:
  explicit LineWriter(std::vector<std::uint8_t>& text) : text_(text) {}

  void vector(const char* keyword, const vec3& v) {
    char* out = word(line_, keyword);
    for (int axis = 0; axis < 3; ++axis) {
      *out++ = ' ';
      out = std::to_chars(out, line_ + kLongestLine, v[axis]).ptr;
    }
    finish(out);
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

}  // namespace

std::vector<std::uint8_t> obj_bytes(std::span<const ExportObject> objects, const dvec3& origin) {
  std::vector<std::uint8_t> text;
  text.reserve(kTypicalLine * (count_lines(objects) + 1));
  const auto add = [&text](std::string_view line) {
    text.insert(text.end(), line.begin(), line.end());
  };
  add("# metres, right-handed, y up\n");
  if (const std::string from = origin_text(origin); !from.empty()) add("# " + from + "\n");
  LineWriter line(text);
  std::uint32_t first = 1;
  for (const ExportObject& object : objects) {
    add("o " + object.name + '\n');
    for (const vec3& position : object.mesh->positions) line.vector("v", position);
    for (const vec3& normal : object.mesh->normals) line.vector("vn", normal);
    for (const uvec3& triangle : object.mesh->triangles) line.face(triangle, first);
    first += static_cast<std::uint32_t>(object.mesh->positions.size());
  }
  return text;
}

}  // namespace aerostat::mesh
