#include "asset/obj_faces.hpp"

#include <functional>
#include <span>
#include <unordered_map>

#include <fmt/format.h>

#include "asset/polygon.hpp"
#include "asset/words.hpp"
#include "core/math.hpp"

namespace aerostat::asset {
namespace {

struct HashOfCorner {
  std::size_t operator()(const ObjCorner& corner) const {
    std::uint64_t hash = corner.point;
    for (const std::uint32_t part : {corner.uv, corner.normal}) {
      hash = (hash ^ (hash >> 29)) * 0xbf58476d1ce4e5b9u + part;
    }
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

/// Builds the vertices and triangles of one primitive.
class Builder {
 public:
  Builder(const ObjKey& key, const ObjVertices& vertices, const std::vector<vec3>& positions,
          Budget& budget)
      : key_(key), vertices_(vertices), positions_(positions), budget_(budget) {}

  void add_face(std::span<const ObjCorner> corners, std::uint32_t line) {
    outline_.clear();
    for (const ObjCorner& corner : corners) {
      require(corner.point, vertices_.points.size(), "vertex", line);
      if (key_.has_uv) require(corner.uv, vertices_.uv.size(), "texture coordinate", line);
      if (key_.has_normals) require(corner.normal, vertices_.normals.size(), "normal", line);
      outline_.push_back(vertices_.points[corner.point]);
    }
    triangles_.clear();
    triangulate(outline_, triangles_);
    for (const auto& triangle : triangles_) {
      std::array<std::uint32_t, 3> placed{};
      for (std::size_t i = 0; i < 3; ++i) placed[i] = vertex(corners[triangle[i]]);
      primitive_.triangles.push_back(placed);
    }
  }

  Primitive finished(vec2 scale, vec2 offset) {
    for (vec2& uv : primitive_.uv) {
      const vec2 moved = uv * scale + offset;
      uv = {moved.x, 1.0f - moved.y};
    }
    if (key_.is_smooth && !key_.has_normals) smooth();
    return std::move(primitive_);
  }

 private:
  static void require(std::uint32_t index, std::size_t count, const char* what,
                      std::uint32_t line) {
    if (index < count) return;
    refuse(fmt::format("line {}: found {} {}, but the file has {}", line, what,
                       std::uint64_t{index} + 1, count));
  }

  std::uint32_t vertex(ObjCorner corner) {
    if (!key_.has_uv) corner.uv = kNoIndex;
    if (!key_.has_normals) corner.normal = kNoIndex;
    const auto next = static_cast<std::uint32_t>(primitive_.positions.size());
    const auto [found, is_new] = known_.try_emplace(corner, next);
    if (!is_new) return found->second;
    budget_.take_vertices(1);
    primitive_.positions.push_back(positions_[corner.point]);
    points_.push_back(corner.point);
    if (key_.has_uv) primitive_.uv.push_back(vertices_.uv[corner.uv]);
    if (key_.has_normals) primitive_.normals.push_back(vertices_.normals[corner.normal]);
    if (!vertices_.colors.empty()) primitive_.colors.push_back(vertices_.colors[corner.point]);
    return next;
  }

  /// Gives each vertex the mean of the normals of the triangles around its point, weighted by area.
  void smooth() {
    std::unordered_map<std::uint32_t, dvec3> sums;
    for (const auto& [a, b, c] : primitive_.triangles) {
      const dvec3 from(primitive_.positions[a]);
      const dvec3 area =
          glm::cross(dvec3(primitive_.positions[b]) - from, dvec3(primitive_.positions[c]) - from);
      if (!is_finite(area)) continue;
      for (const std::uint32_t corner : {a, b, c}) sums[points_[corner]] += area;
    }
    for (const std::uint32_t point : points_) {
      const dvec3 sum = sums[point];
      const double length = glm::length(sum);
      primitive_.normals.push_back(length > 0.0 ? vec3(sum / length) : vec3(0.0f));
    }
  }

  const ObjKey& key_;
  const ObjVertices& vertices_;
  const std::vector<vec3>& positions_;
  Budget& budget_;
  Primitive primitive_;
  std::vector<std::uint32_t> points_;  // of the vertices
  std::unordered_map<ObjCorner, std::uint32_t, HashOfCorner> known_;
  std::vector<dvec3> outline_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

Primitive primitive_of(const ObjFaces& faces, const ObjKey& key, const ObjVertices& vertices,
                       const std::vector<vec3>& positions, vec2 scale, vec2 offset,
                       Budget& budget) {
  Builder builder(key, vertices, positions, budget);
  std::span<const ObjCorner> left(faces.corners);
  for (std::size_t i = 0; i < faces.sizes.size(); ++i) {
    builder.add_face(left.first(faces.sizes[i]), faces.lines[i]);
    left = left.subspan(faces.sizes[i]);
  }
  return builder.finished(scale, offset);
}

}  // namespace aerostat::asset
