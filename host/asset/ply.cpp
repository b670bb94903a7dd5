#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "asset/ply_header.hpp"
#include "asset/ply_values.hpp"
#include "asset/polygon.hpp"
#include "asset/reading.hpp"
#include "asset/words.hpp"
#include "core/error.hpp"
#include "track/text.hpp"

namespace aerostat::asset {
namespace {

using glm::dvec3;
using glm::vec2;
using glm::vec4;

/// What a number of a vertex or a face may mean. `none` stands for what is passed over.
enum Meaning { x, y, z, nx, ny, nz, red, green, blue, alpha, u, v, none };
constexpr int kMeanings = none;

struct Word {
  std::string_view name;
  Meaning meaning;
};

constexpr std::array<Word, 23> kWords = {{{"x", x},
                                          {"y", y},
                                          {"z", z},
                                          {"nx", nx},
                                          {"ny", ny},
                                          {"nz", nz},
                                          {"red", red},
                                          {"green", green},
                                          {"blue", blue},
                                          {"alpha", alpha},
                                          {"r", red},
                                          {"g", green},
                                          {"b", blue},
                                          {"diffuse_red", red},
                                          {"diffuse_green", green},
                                          {"diffuse_blue", blue},
                                          {"u", u},
                                          {"v", v},
                                          {"s", u},
                                          {"t", v},
                                          {"texture_u", u},
                                          {"texture_v", v},
                                          {"a", alpha}}};

Meaning meaning_of(const PlyProperty& property) {
  if (property.count_type) return none;
  const auto found = std::find_if(kWords.begin(), kWords.end(),
                                  [&](const Word& each) { return each.name == property.name; });
  return found == kWords.end() ? none : found->meaning;
}

/// Returns the number that stands for full light in a type.
double full(PlyType type) {
  switch (type) {
    case PlyType::int8:
      return 127.0;
    case PlyType::uint8:
      return 255.0;
    case PlyType::int16:
      return 32767.0;
    case PlyType::uint16:
      return 65535.0;
    case PlyType::int32:
      return 2147483647.0;
    case PlyType::uint32:
      return 4294967295.0;
    case PlyType::float32:
    case PlyType::float64:
      break;
  }
  return 1.0;
}

/// The numbers of an element that mean something.
struct Row {
  std::array<double, kMeanings> numbers{};

  dvec3 position() const { return {numbers[x], numbers[y], numbers[z]}; }
  glm::vec3 normal() const { return glm::vec3(dvec3(numbers[nx], numbers[ny], numbers[nz])); }
  vec2 uv() const { return {static_cast<float>(numbers[u]), static_cast<float>(1.0 - numbers[v])}; }
  vec4 color() const {
    vec4 color;
    for (int i = 0; i < 3; ++i) {
      color[i] = linear_of_srgb(static_cast<float>(numbers[static_cast<std::size_t>(red + i)]));
    }
    color.a = static_cast<float>(numbers[alpha]);
    return color;
  }
};

/// Tells which meanings the properties of an element have.
struct Columns {
  explicit Columns(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) {
      meanings.push_back(meaning_of(property));
      if (meanings.back() != none) has[meanings.back()] = true;
    }
  }
  bool has_all(std::initializer_list<Meaning> wanted) const {
    return std::all_of(wanted.begin(), wanted.end(), [&](Meaning each) { return has[each]; });
  }

  std::vector<Meaning> meanings;
  std::array<bool, kMeanings> has{};
};

class PlyReader {
 public:
  explicit PlyReader(Reading& reading)
      : reading_(reading),
        header_(read_ply_header(reading.bytes)),
        values_(reading.bytes, header_) {}

  void read() {
    for (const PlyElement& element : header_.elements) {
      values_.require_room(element);
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else if (element.name == "tristrips") {
        read_strips(element);
      } else {
        pass_over(element);
      }
    }
    if (sizes_.empty()) {
      refuse(points_.empty() ? "the file has no vertices"
                             : fmt::format("found a point cloud of {} without faces, expected "
                                           "triangles or polygons",
                                           track::counted(points_.size(), "vertex", "vertices")));
    }
    add_mesh(reading_.model, {}, {primitive()});
    add_material();
  }

 private:
  /// Reads the numbers of an element. Lists are handed to `take_list`.
  template <class TakeList>
  Row read_row(const PlyElement& element, const Columns& columns, const TakeList& take_list) {
    Row row;
    row.numbers[alpha] = 1.0;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.count_type) {
        const std::size_t length = values_.next_length(*property.count_type, property.type);
        take_list(property, length);
        continue;
      }
      const double number = values_.next(property.type);
      const Meaning meaning = columns.meanings[i];
      if (meaning == none) continue;
      const bool is_color = meaning >= red && meaning <= alpha;
      row.numbers[meaning] = is_color ? number / full(property.type) : number;
    }
    return row;
  }

  void pass_over_list(const PlyProperty& property, std::size_t length) {
    for (std::size_t i = 0; i < length; ++i) values_.next(property.type);
  }

  void pass_over(const PlyElement& element) {
    const Columns columns(element);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      read_row(element, columns, [this](const PlyProperty& property, std::size_t length) {
        pass_over_list(property, length);
      });
    }
  }

  void read_vertices(const PlyElement& element) {
    const Columns columns(element);
    if (!points_.empty()) refuse("found vertices twice, expected them once");
    if (!columns.has_all({x, y, z})) refuse("the vertices have no properties x, y and z");
    reading_.budget.take_vertices(element.count);
    const bool has_normals = columns.has_all({nx, ny, nz});
    const bool has_colors = columns.has_all({red, green, blue}), has_uv = columns.has_all({u, v});
    for (std::uint64_t i = 0; i < element.count; ++i) {
      const Row row = read_row(
          element, columns,
          [this](const PlyProperty& each, std::size_t length) { pass_over_list(each, length); });
      points_.push_back(row.position());
      if (has_normals) vertices_.normals.push_back(row.normal());
      if (has_colors) vertices_.colors.push_back(row.color());
      if (has_uv) vertices_.uv.push_back(row.uv());
    }
  }

  /// Reads the next index of a vertex. It is compared with the number of vertices later, because
  /// the faces may come first in the file.
  std::uint32_t next_index(PlyType type) {
    const double index = values_.next(type);
    if (!(index >= 0.0) || index != std::floor(index) ||
        index > static_cast<double>(std::numeric_limits<std::uint32_t>::max())) {
      values_.fail(fmt::format("vertex {}", index), "the number of a vertex, from 0");
    }
    return static_cast<std::uint32_t>(index);
  }

  void read_faces(const PlyElement& element) {
    const Columns columns(element);
    const bool has_colors = columns.has_all({red, green, blue});
    for (std::uint64_t i = 0; i < element.count; ++i) {
      const std::size_t first = corners_.size();
      const Row row = read_row(element, columns, [&](const PlyProperty& each, std::size_t length) {
        take_face_list(each, length);
      });
      end_polygon(first);
      if (has_colors) corner_colors_.resize(corners_.size(), row.color());
    }
  }

  void take_face_list(const PlyProperty& property, std::size_t length) {
    const bool is_corners = property.name == "vertex_indices" || property.name == "vertex_index";
    if (!is_corners && property.name != "texcoord") return pass_over_list(property, length);
    if (is_corners) {
      if (length > kMostCorners) {
        values_.fail(fmt::format("a face of {} corners", length),
                     fmt::format("at most {}", kMostCorners));
      }
      reading_.budget.take_triangles(length < 3 ? 0 : length - 2);
      for (std::size_t i = 0; i < length; ++i) corners_.push_back(next_index(property.type));
      return;
    }
    for (std::size_t i = 0; i + 1 < length; i += 2) {
      const double u = values_.next(property.type), v = values_.next(property.type);
      face_uv_.emplace_back(static_cast<float>(u), static_cast<float>(1.0 - v));
    }
    if (length % 2 == 1) values_.next(property.type);
  }

  /// Ends the polygon whose corners begin at `first`.
  void end_polygon(std::size_t first) {
    sizes_.push_back(static_cast<std::uint32_t>(corners_.size() - first));
    if (face_uv_.empty() && corner_uv_.empty()) return;
    // If one face has texture coordinates, all get some, so that each corner has its own.
    corner_uv_.resize(first, vec2(0.0f));
    corner_uv_.insert(corner_uv_.end(), face_uv_.begin(), face_uv_.end());
    corner_uv_.resize(corners_.size(), vec2(0.0f));
    face_uv_.clear();
  }

  /// Reads strips of triangles. Every other triangle is turned over, and -1 begins a new strip.
  void read_strips(const PlyElement& element) {
    const Columns columns(element);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      read_row(element, columns, [this](const PlyProperty& property, std::size_t length) {
        std::vector<std::uint32_t> strip;
        for (std::size_t k = 0; k < length; ++k) {
          const double index = values_.next(property.type);
          if (index == -1.0) {
            strip.clear();
            continue;
          }
          if (!(index >= 0.0 && index <= 4294967295.0)) {
            values_.fail(fmt::format("vertex {}", index), "the number of a vertex, or -1");
          }
          strip.push_back(static_cast<std::uint32_t>(index));
          if (strip.size() < 3) continue;
          reading_.budget.take_triangles(1);
          const std::size_t n = strip.size();
          const bool is_odd = n % 2 == 0;
          corners_.insert(corners_.end(), {strip[n - 3], strip[is_odd ? n - 1 : n - 2],
                                           strip[is_odd ? n - 2 : n - 1]});
          end_polygon(corners_.size() - 3);
        }
      });
    }
  }

  /// Calls `take` with the three corners of each triangle, as places in `corners_`.
  template <class Take>
  void each_triangle(const Take& take) const {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<dvec3> outline;
    std::size_t first = 0, face = 0;
    for (const std::uint32_t size : sizes_) {
      outline.clear();
      for (std::size_t i = first; i < first + size; ++i) {
        if (corners_[i] >= points_.size()) {
          refuse(fmt::format("face {}: found vertex {}, but there are {}, counted from 0", face,
                             corners_[i], points_.size()));
        }
        outline.push_back(points_[corners_[i]]);
      }
      triangles.clear();
      triangulate(outline, triangles);
      for (const auto& [a, b, c] : triangles) take(first + a, first + b, first + c);
      first += size;
      ++face;
    }
  }

  /// Returns the triangles. If corners have their own uv or colours, no vertex is shared.
  Primitive primitive() {
    Primitive result;
    const std::vector<glm::vec3> positions = around_origin(points_, reading_.model);
    if (corner_uv_.empty() && corner_colors_.empty()) {
      result = std::move(vertices_);
      result.positions = positions;
      each_triangle([&](std::size_t a, std::size_t b, std::size_t c) {
        result.triangles.push_back({corners_[a], corners_[b], corners_[c]});
      });
      return result;
    }
    reading_.budget.take_vertices(corners_.size());
    const bool has_colors = !corner_colors_.empty() || !vertices_.colors.empty();
    const bool has_uv = !corner_uv_.empty() || !vertices_.uv.empty();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const std::uint32_t from = corners_[i];
      const bool is_known = from < positions.size();
      result.positions.push_back(is_known ? positions[from] : glm::vec3(0.0f));
      if (!vertices_.normals.empty()) {
        result.normals.push_back(is_known ? vertices_.normals[from] : glm::vec3(0.0f));
      }
      if (has_uv) result.uv.push_back(uv_of(i));
      if (has_colors) result.colors.push_back(color_of(i));
    }
    each_triangle([&](std::size_t a, std::size_t b, std::size_t c) {
      result.triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                  static_cast<std::uint32_t>(c)});
    });
    return result;
  }

  vec4 color_of(std::size_t corner) const {
    if (corner < corner_colors_.size()) return corner_colors_[corner];
    const std::uint32_t from = corners_[corner];
    return from < vertices_.colors.size() ? vertices_.colors[from] : vec4(1.0f);
  }

  vec2 uv_of(std::size_t corner) const {
    if (corner < corner_uv_.size()) return corner_uv_[corner];
    const std::uint32_t from = corners_[corner];
    return corner_uv_.empty() && from < vertices_.uv.size() ? vertices_.uv[from] : vec2(0.0f);
  }

  void add_material() {
    Material material = plain_material();
    const bool has_colors =
        !corner_colors_.empty() || !reading_.model.meshes[0].primitives[0].colors.empty();
    if (has_colors || !header_.texture_file.empty()) material.base_color = glm::vec4(1.0f);
    if (!header_.texture_file.empty()) {
      try {
        const auto path = reading_.files.find(header_.texture_file);
        material.base_color_texture =
            TextureUse{add_texture(reading_, reading_.files.read(path), header_.texture_file)};
      } catch (const Error& error) {
        reading_.note(fmt::format("The texture is left out: {}.", error.what()));
        show_missing_texture(material);
      }
    }
    reading_.model.materials.push_back(material);
  }

  Reading& reading_;
  PlyHeader header_;
  PlyValues values_;
  std::vector<dvec3> points_;
  Primitive vertices_;                  // the other attributes of the vertices
  std::vector<std::uint32_t> corners_;  // of all polygons, one behind the other
  std::vector<std::uint32_t> sizes_;    // of the polygons
  std::vector<vec2> face_uv_;           // of the corners of the face that is being read
  std::vector<vec2> corner_uv_;         // empty, or one for each corner
  std::vector<vec4> corner_colors_;     // empty, or one for each corner
};

}  // namespace

void read_ply(Reading& reading) {
  PlyReader(reading).read();
}

}  // namespace aerostat::asset
