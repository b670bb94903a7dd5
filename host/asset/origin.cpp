#include <cmath>

#include "asset/reading.hpp"
#include "core/math.hpp"

namespace aerostat::asset {

dvec3 far_origin(const Bounds& box) {
  dvec3 origin = glm::round(0.5 * box.least + 0.5 * box.most);
  for (int i = 0; i < 3; ++i) {
    const bool is_far = std::isfinite(origin[i]) && std::abs(origin[i]) > kFarFromOrigin;
    if (!is_far) origin[i] = 0.0;
  }
  return origin;
}

std::vector<vec3> around_origin(std::span<const dvec3> points, Model& model) {
  Bounds box;
  for (const dvec3& point : points) {
    if (is_finite(point)) box.add(point);
  }
  model.origin = far_origin(box);
  std::vector<vec3> near;
  near.reserve(points.size());
  for (const dvec3& point : points) near.emplace_back(point - model.origin);
  return near;
}

void add_mesh(Model& model, std::string name, std::vector<Primitive> primitives) {
  model.meshes.push_back({std::move(name), std::move(primitives)});
  model.placements.push_back({model.meshes.size() - 1, glm::dmat4(1.0)});
}

}  // namespace aerostat::asset
