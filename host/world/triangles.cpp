#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "world/exported_model.hpp"
#include "world/world.hpp"

namespace aerostat::world {
namespace {

/// Appends the triangles of a model at the place of an instance.
void place(const mesh::TriangleMesh& model, const scatter::Instance& instance,
           mesh::TriangleMesh& mesh) {
  const scatter::Axes axes = scatter::axes_of(instance);
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  const auto turned = [&](const vec3& v) { return axes.x * v.x + axes.y * v.y + axes.z * v.z; };
  for (std::size_t i = 0; i < model.positions.size(); ++i) {
    mesh.positions.push_back(instance.position + turned(model.positions[i]));
    mesh.normals.push_back(turned(model.normals[i]) / instance.scale);
    const vec3 color = model.colors.empty() ? vec3(1.0f) : model.colors[i];
    mesh.colors.push_back(color * instance.tint);
  }
  for (const uvec3& triangle : model.triangles) mesh.triangles.push_back(triangle + base);
}

/// Appends the triangles of a shape.
class Appender {
 public:
  Appender(Objects& objects, Placed instances) : objects_(objects), placed_(instances) {}

  void operator()(const Objects& objects) {
    objects_.insert(objects_.end(), objects.begin(), objects.end());
  }

  void operator()(const HeightGrid& grid) {
    objects_.push_back(
        {scene::ObjectId::terrain, scene::MaterialId::terrain, mesh::to_triangles(*grid.mesh)});
  }

  void operator()(const Instances& instances) {
    if (instances.are_plants && placed_ == Placed::left_out) return;
    std::map<std::tuple<scene::ObjectId, scene::MaterialId, std::optional<std::uint32_t>>,
             mesh::TriangleMesh>
        found;
    for (const scatter::Instance& instance : instances.places) {
      const InstanceModel& model = instances.models[instance.model];
      for (const Object& part : *model.parts) {
        auto number = part.file_material;
        if (number) *number += model.first_file_material;
        place(part.mesh, instance, found[{part.id, part.material, number}]);
      }
    }
    for (auto& [what, mesh] : found) {
      Object object{std::get<0>(what), std::get<1>(what), std::move(mesh)};
      object.file_material = std::get<2>(what);
      objects_.push_back(std::move(object));
    }
  }

 private:
  Objects& objects_;
  Placed placed_;
};

std::uint64_t triangles_of(const Objects& objects) {
  std::uint64_t count = 0;
  for (const Object& object : objects) count += object.mesh.triangles.size();
  return count;
}

/// Counts the triangles of a shape, of instances those of each place, or those of each model.
struct Counter {
  Placed placed;
  bool counts_places = true;

  std::uint64_t operator()(const Objects& objects) const { return triangles_of(objects); }
  std::uint64_t operator()(const HeightGrid& grid) const { return grid.mesh->triangles(); }

  std::uint64_t operator()(const Instances& instances) const {
    if (instances.are_plants && placed == Placed::left_out) return 0;
    std::vector<std::uint64_t> of_model;
    for (const InstanceModel& model : instances.models) {
      of_model.push_back(triangles_of(*model.parts));
    }
    std::uint64_t count = 0;
    if (counts_places) {
      for (const scatter::Instance& place : instances.places) count += of_model[place.model];
    } else {
      for (const std::uint64_t triangles : of_model) count += triangles;
    }
    return count;
  }
};

std::uint64_t count_by(const World& world, const Counter& counter) {
  std::uint64_t count = 0;
  for (const Group& group : world.groups) {
    if (group.shape) count += std::visit(counter, *group.shape);
  }
  return count;
}

}  // namespace

std::uint64_t count_triangles(const World& world, Placed instances) {
  return count_by(world, {instances, true});
}

std::uint64_t count_model_triangles(const World& world, Placed instances) {
  return count_by(world, {instances, false});
}

Objects as_triangles(const World& world, Placed instances) {
  Objects objects;
  for (const Group& group : world.groups) {
    if (group.shape) std::visit(Appender(objects, instances), *group.shape);
  }
  return objects;
}

}  // namespace aerostat::world
