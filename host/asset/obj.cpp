#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "asset/obj_faces.hpp"
#include "asset/obj_materials.hpp"
#include "asset/polygon.hpp"
#include "asset/reading.hpp"
#include "asset/words.hpp"
#include "track/text.hpp"

namespace aerostat::asset {
namespace {

using glm::dvec3;
using glm::vec2;
using glm::vec3;
using glm::vec4;

/// Faces of one material are kept apart by three properties: whether they have texture coordinates,
/// whether they have normals, and whether they are smooth.
constexpr std::size_t kGroupsOfMaterial = 8;

/// Reads the lines of an OBJ file.
class ObjReader {
 public:
  explicit ObjReader(Reading& reading)
      : reading_(reading), lines_(reading.bytes), materials_(reading) {}

  void read() {
    std::string_view line;
    std::string joined;
    while (lines_.next(line)) {
      if (!line.empty() && line.back() == '\\') line = join(line, joined);
      take(line);
    }
    if (groups_.empty()) {
      refuse(vertices_.points.empty()
                 ? "found neither vertices nor faces of an OBJ file"
                 : fmt::format("found {} without faces, expected triangles or polygons",
                               track::counted(vertices_.points.size(), "vertex", "vertices")));
    }
    scale_colors();
    note_left_out();
    build();
  }

 private:
  /// Returns a line that ends in a backslash, joined with the lines that continue it.
  std::string_view join(std::string_view line, std::string& joined) {
    joined = line;
    while (!joined.empty() && joined.back() == '\\') {
      joined.back() = ' ';
      if (lines_.next(line)) joined += line;
    }
    return joined;
  }

  void take(std::string_view line) {
    Words words(line);
    const std::string_view key = words.next();
    if (key.empty() || key[0] == '#') return;
    if (key == "v") return take_point(words);
    if (key == "vt") return take_uv(words);
    if (key == "vn") return take_normal(words);
    if (key == "f" || key == "fo") return take_face(words);
    if (key == "usemtl") {
      now_.material = words.rest();
    } else if (key == "s") {
      const std::string_view group = words.next();
      now_.is_smooth = group != "off" && group != "0" && !group.empty();
    } else if (key == "o" || key == "g") {
      if (name_.empty()) name_ = track::clean_text(words.rest());
    } else if (key == "mtllib") {
      if (libraries_.size() == kMostLibraries) {
        fail("one more mtllib", fmt::format("at most {}", kMostLibraries));
      }
      libraries_.emplace_back(words.rest());
    } else if (key == "l" || key == "p") {
      ++lines_and_points_;
    } else if (key == "curv" || key == "curv2" || key == "surf") {
      ++curves_;
    }
  }

  double number(Words& words) const { return real_at(words.next(), lines_.number()); }
  float small(Words& words) const { return static_cast<float>(number(words)); }

  [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
    refuse(fmt::format("line {}: found {}, expected {}", lines_.number(), found, expected));
  }

  void require_few(std::size_t count, const char* what) const {
    const std::size_t most = reading_.budget.limits().vertices;
    if (count < most) return;
    fail(fmt::format("more than {} {}", most, what), "no more");
  }

  /// Reads "x y z", with a weight or a colour behind them that programs of scanners write.
  void take_point(Words& words) {
    require_few(vertices_.points.size(), "vertices");
    dvec3 point;
    for (int i = 0; i < 3; ++i) point[i] = number(words);
    std::array<float, 4> more{};
    std::size_t count = 0;
    for (std::string_view word = words.next(); !word.empty() && word[0] != '#' && count < 4;
         word = words.next()) {
      more[count++] = static_cast<float>(real_at(word, lines_.number()));
    }
    vertices_.points.push_back(point);
    if (count >= 3 || !vertices_.colors.empty()) {
      vertices_.colors.resize(vertices_.points.size(), vec4(1.0f));
    }
    if (count >= 3) vertices_.colors.back() = {more[0], more[1], more[2], 1.0f};
  }

  void take_uv(Words& words) {
    require_few(vertices_.uv.size(), "texture coordinates");
    const float u = small(words);
    const std::string_view v = words.next();
    vertices_.uv.emplace_back(u,
                              v.empty() ? 0.0f : static_cast<float>(real_at(v, lines_.number())));
  }

  void take_normal(Words& words) {
    require_few(vertices_.normals.size(), "normals");
    vec3 normal;
    for (int i = 0; i < 3; ++i) normal[i] = small(words);
    vertices_.normals.push_back(normal);
  }

  void take_face(Words& words) {
    face_.clear();
    for (std::string_view word = words.next(); !word.empty() && word[0] != '#';
         word = words.next()) {
      if (face_.size() == kMostCorners) {
        fail("a face of more corners", fmt::format("at most {}", kMostCorners));
      }
      face_.push_back(corner(word));
    }
    if (face_.size() < 3) {
      ++small_faces_;
      return;
    }
    reading_.budget.take_triangles(face_.size() - 2);
    ObjKey key = now_;
    key.has_uv = std::all_of(face_.begin(), face_.end(),
                             [](const ObjCorner& each) { return each.uv != kNoIndex; });
    key.has_normals = std::all_of(face_.begin(), face_.end(),
                                  [](const ObjCorner& each) { return each.normal != kNoIndex; });
    ObjFaces& group = group_of(key);
    group.corners.insert(group.corners.end(), face_.begin(), face_.end());
    group.sizes.push_back(static_cast<std::uint32_t>(face_.size()));
    group.lines.push_back(static_cast<std::uint32_t>(lines_.number()));
  }

  ObjFaces& group_of(const ObjKey& key) {
    const auto known = places_.find(key);
    if (known != places_.end()) return groups_[known->second].second;
    const std::size_t most = kGroupsOfMaterial * reading_.budget.limits().materials;
    if (groups_.size() == most)
      fail("faces of yet another material", fmt::format("at most {}", most));
    places_.emplace(key, groups_.size());
    groups_.emplace_back(key, ObjFaces());
    return groups_.back().second;
  }

  /// Reads a corner such as "3", "3/1", "3//2" or "-1/-1/-1".
  ObjCorner corner(std::string_view word) const {
    std::array<std::string_view, 3> parts;
    std::string_view rest = word;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      parts[i] = rest.substr(0, rest.find('/'));
      rest.remove_prefix(std::min(parts[i].size() + 1, rest.size()));
    }
    ObjCorner corner;
    corner.point = index(parts[0], vertices_.points.size(), word);
    if (!parts[1].empty()) corner.uv = index(parts[1], vertices_.uv.size(), word);
    if (!parts[2].empty()) corner.normal = index(parts[2], vertices_.normals.size(), word);
    if (!rest.empty()) fail(in_quotes(word), "a corner such as 1, 1/2, 1//3 or 1/2/3");
    return corner;
  }

  /// Returns an index counted from 0. Negative ones count back from the last of `count` before
  /// them.
  std::uint32_t index(std::string_view text, std::size_t count, std::string_view word) const {
    const std::optional<std::int64_t> number = integer_of(text);
    const auto so_far = static_cast<std::int64_t>(count);
    const bool fits = number && *number != 0 && *number >= -so_far &&
                      *number <= static_cast<std::int64_t>(reading_.budget.limits().vertices);
    if (!fits) {
      fail(in_quotes(word), fmt::format("numbers from 1, or from -1 to -{} counted backwards",
                                        std::max(count, std::size_t{1})));
    }
    return static_cast<std::uint32_t>(*number > 0 ? *number - 1 : so_far + *number);
  }

  /// Makes colours linear. Some programs write them from 0 to 255.
  void scale_colors() {
    std::vector<vec4>& colors = vertices_.colors;
    colors.resize(colors.empty() ? 0 : vertices_.points.size(), vec4(1.0f));
    const bool are_bytes = std::any_of(colors.begin(), colors.end(), [](const vec4& color) {
      return color.r > 1.0f || color.g > 1.0f || color.b > 1.0f;
    });
    for (vec4& color : colors) {
      for (int i = 0; i < 3; ++i) color[i] = linear_of_srgb(color[i] / (are_bytes ? 255.0f : 1.0f));
    }
    if (are_bytes) reading_.note("The colours of the vertices were taken as numbers up to 255.");
  }

  void note_left_out() {
    const auto note = [&](std::size_t count, const char* one, const char* many) {
      if (count > 0) reading_.note(fmt::format("Left out: {}.", track::counted(count, one, many)));
    };
    note(lines_and_points_, "line or point", "lines and points");
    note(curves_, "curve or curved surface", "curves and curved surfaces");
    note(small_faces_, "face with fewer than three corners", "faces with fewer than three corners");
  }

  void build() {
    for (const std::string& names : libraries_) materials_.read_library(names);
    const std::vector<vec3> positions = around_origin(vertices_.points, reading_.model);
    std::vector<Primitive> primitives;
    for (auto& [key, faces] : groups_) {
      const ObjMaterial material = materials_.of(key.material, !vertices_.colors.empty());
      primitives.push_back(primitive_of(faces, key, vertices_, positions, material.scale,
                                        material.offset, reading_.budget));
      primitives.back().material = material.place;
      faces = ObjFaces();
    }
    add_mesh(reading_.model, name_, std::move(primitives));
  }

  Reading& reading_;
  Lines lines_;
  std::string name_;
  ObjVertices vertices_;
  ObjKey now_;  // of the next face
  std::vector<ObjCorner> face_;
  std::vector<std::pair<ObjKey, ObjFaces>> groups_;
  std::map<ObjKey, std::size_t> places_;  // in `groups_`
  std::vector<std::string> libraries_;
  ObjMaterials materials_;
  std::size_t lines_and_points_ = 0, curves_ = 0, small_faces_ = 0;
};

}  // namespace

void read_obj(Reading& reading) {
  ObjReader(reading).read();
}

}  // namespace aerostat::asset
