#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "asset/bytes.hpp"
#include "asset/reading.hpp"
#include "asset/words.hpp"
#include "track/text.hpp"

namespace aerostat::asset {
namespace {

constexpr std::size_t kHeaderBytes = 84;    // 80 of any content and the number of triangles
constexpr std::size_t kTriangleBytes = 50;  // a normal, three corners and two bytes of any use

/// Adds a mesh of triangles, three points for each of them.
void add_triangles(Reading& reading, const std::vector<glm::dvec3>& points, std::string name) {
  Primitive primitive;
  primitive.positions = around_origin(points, reading.model);
  for (std::uint32_t i = 0; i + 2 < points.size(); i += 3) {
    primitive.triangles.push_back({i, i + 1, i + 2});
  }
  reading.model.materials.push_back(plain_material());
  add_mesh(reading.model, std::move(name), {std::move(primitive)});
}

void read_binary(Reading& reading, std::uint32_t count) {
  reading.budget.take_triangles(count);
  reading.budget.take_vertices(std::uint64_t{3} * count);
  std::vector<glm::dvec3> points;
  points.reserve(std::size_t{3} * count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t corners = kHeaderBytes + i * kTriangleBytes + 12;
    for (std::size_t at = corners; at < corners + 36; at += 12) {
      points.emplace_back(little_at<float>(reading.bytes, at),
                          little_at<float>(reading.bytes, at + 4),
                          little_at<float>(reading.bytes, at + 8));
    }
  }
  add_triangles(reading, points, {});
}

/// Reads the text form. The normals of facets are ignored, because the triangles are flat.
class TextReader {
 public:
  explicit TextReader(Reading& reading) : reading_(reading), lines_(reading.bytes) {}

  void read() {
    std::string_view line;
    while (lines_.next(line)) take(line);
    if (corners_ > 0) refuse("the file ends inside of a facet");
    add_triangles(reading_, points_, std::move(name_));
  }

 private:
  void take(std::string_view line) {
    Words words(line);
    const std::string first = lower_case(words.next());
    if (first == "vertex") {
      if (++corners_ > 3) fail("a fourth vertex", "endloop: facets are triangles");
      reading_.budget.take_vertices(1);
      glm::dvec3 point;
      for (int i = 0; i < 3; ++i) point[i] = real_at(words.next(), lines_.number());
      points_.push_back(point);
    } else if (first == "endloop" || first == "endfacet") {
      if (first == "endfacet" && corners_ == 0) return;
      if (corners_ != 3)
        fail("a facet of " +
                 track::counted(static_cast<std::size_t>(corners_), "vertex", "vertices"),
             "three");
      reading_.budget.take_triangles(1);
      corners_ = 0;
    } else if (first == "solid") {
      if (name_.empty()) name_ = track::clean_text(words.rest());
    } else if (!first.empty() && first != "facet" && first != "outer" && first != "endsolid") {
      fail(in_quotes(line), "solid, facet, outer loop, vertex, endloop, endfacet or endsolid");
    }
  }

  [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
    refuse(fmt::format("line {}: found {}, expected {}", lines_.number(), found, expected));
  }

  Reading& reading_;
  Lines lines_;
  std::string name_;
  std::vector<glm::dvec3> points_;
  int corners_ = 0;  // of the facet that is being read
};

}  // namespace

void read_stl(Reading& reading) {
  const std::string_view bytes = reading.bytes;
  const bool is_long = bytes.size() >= kHeaderBytes;
  const std::uint32_t count = is_long ? little_at<std::uint32_t>(bytes, 80) : 0;
  const std::uint64_t expected = kHeaderBytes + std::uint64_t{kTriangleBytes} * count;
  // Some binary files begin with "solid" as well, so that the length decides.
  if (is_long && expected == bytes.size()) return read_binary(reading, count);
  if (lower_case(track::trimmed(bytes.substr(0, kHeaderBytes)).substr(0, 5)) == "solid") {
    return TextReader(reading).read();
  }
  if (is_long && expected < bytes.size()) {
    reading.note(
        fmt::format("{} bytes behind the last triangle were left out.", bytes.size() - expected));
    return read_binary(reading, count);
  }
  refuse(is_long ? fmt::format("the file has {} bytes, but its {} triangles need {}", bytes.size(),
                               count, expected)
                 : fmt::format("the file has {} bytes, and an STL file has at least {}",
                               bytes.size(), kHeaderBytes));
}

}  // namespace aerostat::asset
