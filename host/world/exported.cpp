#include "world/exported.hpp"

#include "scene/scene.hpp"

namespace aerostat::world {

std::vector<mesh::ExportObject> exported_objects(Objects& triangles, const scene::Scene& scene) {
  std::vector<mesh::ExportObject> objects;
  for (Object& object : triangles) {
    const bool is_sea = scene::material_kind(object.material) == scene::MaterialKind::water;
    if (is_sea) object.mesh.colors.clear();
    objects.push_back({static_cast<std::uint32_t>(object.id), scene::object_name(object.id),
                       &object.mesh, scene::material_name(object.material),
                       scene.material(object.material).albedo});
  }
  return objects;
}

}  // namespace aerostat::world
