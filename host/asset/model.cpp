#include "asset/model.hpp"

#include <limits>

namespace aerostat::asset {

Bounds bounds(const Model& model) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  Bounds box{glm::dvec3(kEndless), glm::dvec3(-kEndless)};
  for (const Placement& placement : model.placements) {
    for (const Primitive& primitive : model.meshes[placement.mesh].primitives) {
      for (const auto& triangle : primitive.triangles) {
        for (const std::uint32_t corner : triangle) {
          const glm::dvec3 point(placement.transform *
                                 glm::dvec4(primitive.positions[corner], 1.0));
          box.least = glm::min(box.least, point);
          box.most = glm::max(box.most, point);
        }
      }
    }
  }
  return box;
}

std::size_t triangle_count(const Mesh& mesh) {
  std::size_t count = 0;
  for (const Primitive& primitive : mesh.primitives) count += primitive.triangles.size();
  return count;
}

std::size_t triangle_count(const Model& model) {
  std::size_t count = 0;
  for (const Mesh& mesh : model.meshes) count += triangle_count(mesh);
  return count;
}

std::size_t placed_triangle_count(const Model& model) {
  std::size_t count = 0;
  for (const Placement& placement : model.placements) {
    count += triangle_count(model.meshes[placement.mesh]);
  }
  return count;
}

}  // namespace aerostat::asset
