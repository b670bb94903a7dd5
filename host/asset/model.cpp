#include "asset/model.hpp"

#include <cmath>

namespace aerostat::asset {
namespace {

/// If more corners than this are placed, the boxes of the meshes are transformed and not the
/// corners. Transforming so many corners takes about a second.
constexpr double kMostCorners = 50e6;

Bounds box_of(const Mesh& mesh) {
  Bounds box;
  for (const Primitive& primitive : mesh.primitives) {
    for (const glm::vec3& position : primitive.positions) box.add(position);
  }
  return box;
}

void add_placed(Bounds& box, const Placement& placement, const Mesh& mesh) {
  for (const Primitive& primitive : mesh.primitives) {
    for (const glm::vec3& position : primitive.positions) {
      box.add(glm::dvec3(placement.transform * glm::dvec4(position, 1.0)));
    }
  }
}

void add_placed(Bounds& box, const Placement& placement, const Bounds& mesh) {
  if (mesh.empty()) return;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 point((corner & 1) != 0 ? mesh.most.x : mesh.least.x,
                           (corner & 2) != 0 ? mesh.most.y : mesh.least.y,
                           (corner & 4) != 0 ? mesh.most.z : mesh.least.z);
    box.add(glm::dvec3(placement.transform * glm::dvec4(point, 1.0)));
  }
}

}  // namespace

Bounds bounds(const Model& model) {
  Bounds box;
  if (static_cast<double>(placed_triangle_count(model)) * 3.0 <= kMostCorners) {
    for (const Placement& placement : model.placements) {
      add_placed(box, placement, model.meshes[placement.mesh]);
    }
    return box;
  }
  std::vector<Bounds> boxes;
  for (const Mesh& mesh : model.meshes) boxes.push_back(box_of(mesh));
  for (const Placement& placement : model.placements) {
    add_placed(box, placement, boxes[placement.mesh]);
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
