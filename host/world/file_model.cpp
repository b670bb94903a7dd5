#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "world/scene_models.hpp"

namespace aerostat::world {
namespace {

/// The share of a model's height in which what stands on the ground lies. Chosen by eye.
constexpr double kBaseShare = 0.02;

/// Moves the triangles of a model's primitives to where they stand.
class Placer {
 public:
  explicit Placer(const asset::Model& model)
      : model_(model), number_(model.materials.size(), kUnused) {
    const asset::Bounds box = asset::bounds(model);
    foot_ = {0.5 * (box.least.x + box.most.x), box.least.y, 0.5 * (box.least.z + box.most.z)};
  }

  std::shared_ptr<const Objects> run() {
    for (const asset::Placement& placement : model_.placements) {
      for (const asset::Primitive& primitive : model_.meshes[placement.mesh].primitives) {
        add(primitive, placement.transform);
      }
    }
    return std::make_shared<const Objects>(std::move(parts_));
  }

 private:
  static constexpr std::size_t kUnused = static_cast<std::size_t>(-1);

  mesh::TriangleMesh& mesh_of(std::size_t material) {
    if (number_[material] == kUnused) {
      number_[material] = parts_.size();
      Object part{scene::ObjectId::model, scene::MaterialId::stone, {}};
      part.file_material = static_cast<std::uint32_t>(material);
      parts_.push_back(std::move(part));
    }
    return parts_[number_[material]].mesh;
  }

  void add(const asset::Primitive& primitive, const glm::dmat4& transform) {
    mesh::TriangleMesh placed;
    const glm::dmat3 linear(transform);
    for (const vec3& position : primitive.positions) {
      placed.positions.push_back(vec3(dvec3(transform * glm::dvec4(dvec3(position), 1.0)) - foot_));
    }
    placed.uvs = primitive.uv;
    for (const glm::vec4& color : primitive.colors) placed.colors.push_back(vec3(color));
    const bool mirrors = glm::determinant(linear) < 0.0;
    for (const auto& [a, b, c] : primitive.triangles) {
      placed.triangles.push_back(mirrors ? uvec3(a, c, b) : uvec3(a, b, c));
    }
    if (primitive.normals.empty()) {
      placed = with_flat_normals(placed);
    } else {
      turn_normals(primitive.normals, linear, placed);
    }
    mesh::append(mesh_of(primitive.material), placed);
  }

  /// Normals go by the inverse transpose of the transform, which is the matrix of cofactors up to a
  /// factor. That matrix exists for flattened models, too. Its sign turns with the winding.
  static void turn_normals(const std::vector<vec3>& normals, const glm::dmat3& linear,
                           mesh::TriangleMesh& mesh) {
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    const double side = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
    for (const vec3& normal : normals) {
      const dvec3 turned = side * (cofactors * dvec3(normal));
      const double length = glm::length(turned);
      mesh.normals.push_back(length > 0.0 ? vec3(turned / length) : vec3(0.0f, 1.0f, 0.0f));
    }
  }

  /// Returns a mesh in which no two triangles share a vertex, so that each has its own normal.
  static mesh::TriangleMesh with_flat_normals(const mesh::TriangleMesh& from) {
    mesh::TriangleMesh flat;
    for (const uvec3& triangle : from.triangles) {
      const auto first = static_cast<std::uint32_t>(flat.positions.size());
      for (int corner = 0; corner < 3; ++corner) {
        const std::uint32_t at = triangle[corner];
        flat.positions.push_back(from.positions[at]);
        if (!from.uvs.empty()) flat.uvs.push_back(from.uvs[at]);
        if (!from.colors.empty()) flat.colors.push_back(from.colors[at]);
      }
      flat.triangles.emplace_back(first, first + 1, first + 2);
    }
    mesh::compute_normals(flat);
    return flat;
  }

  const asset::Model& model_;
  std::vector<std::size_t> number_;  // of the part of each material
  dvec3 foot_{0.0};
  Objects parts_;
};

/// Sets the base of a model to the corners of what lies in the lowest part of its height.
void set_base(FileModel& model) {
  const double top = kBaseShare * model.size.y;
  dvec2 least(model.size.x, model.size.z), most = -least;
  for (const Object& part : *model.parts) {
    for (const vec3& position : part.mesh.positions) {
      if (static_cast<double>(position.y) > top) continue;
      least = glm::min(least, dvec2(position.x, position.z));
      most = glm::max(most, dvec2(position.x, position.z));
    }
  }
  model.base_least = least;
  model.base_most = most;
}

}  // namespace

FileModel file_model(const ModelKey& key, asset::Model model) {
  FileModel result;
  result.key = key;
  result.triangles = asset::placed_triangle_count(model);
  if (result.triangles == 0) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: found no triangles, expected a surface", key.file.string()));
  }
  result.size = asset::bounds(model).size();
  result.parts = Placer(model).run();
  set_base(result);
  result.materials = std::move(model.materials);
  result.textures = std::move(model.textures);
  result.notes = std::move(model.notes);
  return result;
}

}  // namespace aerostat::world
