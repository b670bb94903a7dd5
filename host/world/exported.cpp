#include "world/exported.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "scene/scene.hpp"
#include "world/scene_models.hpp"

namespace aerostat::world {

namespace {

/// The name and the colour of a material.
struct Look {
  std::string name;
  vec3 color{1.0f};
};

/// Returns a material of a file by its number among those of all models. Its name begins with that
/// of the file and has no white space.
Look look_of(std::uint32_t number, const SceneModels& models) {
  std::size_t model = models.models.size() - 1;
  while (models.first_material[model] > number) --model;
  const FileModel& from = *models.models[model];
  const asset::Material& material = from.materials[number - models.first_material[model]];
  std::string name = from.key.file.stem().string() + "-" + material.name;
  for (char& letter : name) {
    if (static_cast<unsigned char>(letter) <= ' ') letter = '_';
  }
  return {std::move(name), vec3(material.base_color)};
}

}  // namespace

std::vector<mesh::ExportObject> exported_objects(Objects& triangles, const scene::Scene& scene,
                                                 const SceneModels& models) {
  std::vector<mesh::ExportObject> objects;
  for (Object& object : triangles) {
    const bool is_sea = scene::material_kind(object.material) == scene::MaterialKind::water;
    if (is_sea) object.mesh.colors.clear();
    const Look look = object.file_material ? look_of(*object.file_material, models)
                                           : Look{scene::material_name(object.material),
                                                  scene.material(object.material).albedo};
    objects.push_back({static_cast<std::uint32_t>(object.id), scene::object_name(object.id),
                       &object.mesh, look.name, look.color});
  }
  return objects;
}

}  // namespace aerostat::world
