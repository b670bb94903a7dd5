#include "world/exported_model.hpp"

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "model/envelope_shape.hpp"
#include "scene/balloons.hpp"
#include "scene/scene.hpp"
#include "world/scene_models.hpp"

namespace aerostat::world {
namespace {

/// Returns the roughness of glTF whose lobe is about as wide as that of Phong's exponent: alpha^2
/// is 2 / (n + 2), as in the reader of OBJ files.
float roughness_of(double shininess) {
  return static_cast<float>(std::pow(2.0 / (shininess + 2.0), 0.25));
}

bool is_leaf_or_cloth(scene::MaterialId id) {
  return id == scene::MaterialId::envelope || id == scene::MaterialId::skirt ||
         id == scene::MaterialId::plant;
}

asset::Material material_of(scene::MaterialId id, const scene::Material& from) {
  asset::Material material;
  material.name = scene::material_name(id);
  material.base_color = glm::vec4(from.albedo, 1.0f);
  material.roughness = roughness_of(from.shininess);
  material.emission = from.emission;
  material.double_sided = is_leaf_or_cloth(id);
  return material;
}

class Exporter {
 public:
  Exporter(const World& world, Placed instances, std::span<const asset::Texture> cloths)
      : world_(world), placed_(instances), cloths_(cloths) {
    model_.origin = world.scene.origin();
    for (std::size_t i = 0; world.models && i < world.models->models.size(); ++i) add_file(i);
  }

  asset::Model run() {
    for (const Group& group : world_.groups) {
      if (group.shape) std::visit(*this, *group.shape);
    }
    if (model_.materials.empty()) model_.materials.emplace_back();
    return std::move(model_);
  }

  void operator()(const Objects& objects) {
    for (const Object& object : objects) {
      const std::size_t mesh = add_mesh({object}, 0);
      if (is_dyed(object)) dye(object, model_.meshes[mesh].primitives.front());
      place(mesh, glm::dmat4(1.0));
    }
  }

  void operator()(const HeightGrid& grid) {
    Objects land;
    land.push_back(
        {scene::ObjectId::terrain, scene::MaterialId::terrain, mesh::to_triangles(*grid.mesh)});
    place(add_mesh(land, 0), glm::dmat4(1.0));
  }

  void operator()(const Instances& instances) {
    if (instances.are_plants && placed_ == Placed::left_out) return;
    std::vector<std::optional<std::size_t>> meshes(instances.models.size());
    for (const scatter::Instance& instance : instances.places) {
      std::optional<std::size_t>& mesh = meshes[instance.model];
      if (!mesh) {
        const InstanceModel& from = instances.models[instance.model];
        mesh = add_mesh(*from.parts, from.first_file_material);
      }
      const scatter::Axes axes = scatter::axes_of(instance);
      place(*mesh, {glm::dvec4(axes.x, 0.0), glm::dvec4(axes.y, 0.0), glm::dvec4(axes.z, 0.0),
                    glm::dvec4(instance.position, 1.0)});
    }
  }

 private:
  /// Adds the materials and textures of a file, which have the numbers of SceneModels.
  void add_file(std::size_t number) {
    const FileModel& file = *world_.models->models[number];
    const std::size_t first = model_.textures.size();
    model_.textures.insert(model_.textures.end(), file.textures.begin(), file.textures.end());
    for (asset::Material material : file.materials) {
      for (auto* use : {&material.base_color_texture, &material.metallic_roughness_texture,
                        &material.normal_texture, &material.emission_texture}) {
        if (*use) (*use)->texture += first;
      }
      model_.materials.push_back(std::move(material));
    }
  }

  std::size_t number_of(const Object& object, std::uint32_t first_file_material) {
    if (object.file_material) return *object.file_material + first_file_material;
    const auto [entry, is_new] = fixed_.try_emplace(object.material, model_.materials.size());
    if (is_new) {
      model_.materials.push_back(
          material_of(object.material, world_.scene->material(object.material)));
    }
    return entry->second;
  }

  std::size_t add_mesh(const Objects& parts, std::uint32_t first_file_material) {
    asset::Mesh mesh;
    for (const Object& part : parts) {
      if (mesh.name.empty()) mesh.name = scene::object_name(part.id);
      asset::Primitive primitive;
      primitive.material = number_of(part, first_file_material);
      primitive.positions = part.mesh.positions;
      primitive.normals = part.mesh.normals;
      if (part.file_material) primitive.uv = part.mesh.uvs;
      // Vertices of water have depths in place of colours.
      if (scene::material_kind(part.material) != scene::MaterialKind::water || part.file_material) {
        for (const vec3& color : part.mesh.colors) primitive.colors.emplace_back(color, 1.0f);
      }
      for (const uvec3& triangle : part.mesh.triangles) {
        primitive.triangles.push_back({triangle.x, triangle.y, triangle.z});
      }
      mesh.primitives.push_back(std::move(primitive));
    }
    model_.meshes.push_back(std::move(mesh));
    return model_.meshes.size() - 1;
  }

  bool is_dyed(const Object& object) const {
    return object.id == scene::ObjectId::envelope && object.balloon < cloths_.size() &&
           cloths_[object.balloon].width > 0;
  }

  /// Lays the texture of a cloth on the mesh of an envelope.
  void dye(const Object& envelope, asset::Primitive& primitive) {
    const scene::Balloon& balloon = *scene::balloons_of(*world_.scene)[envelope.balloon];
    const model::EnvelopeShape shape(balloon.diameter_m, balloon.gores);
    asset::Material material = model_.materials[primitive.material];
    material.base_color_texture =
        asset::TextureUse{model_.textures.size(), asset::Wrap::repeat, asset::Wrap::clamp};
    model_.textures.push_back(cloths_[envelope.balloon]);
    primitive.material = model_.materials.size();
    model_.materials.push_back(std::move(material));
    primitive.colors.clear();
    for (const vec2& uv : envelope.mesh.uvs) {
      primitive.uv.emplace_back(uv.x / static_cast<float>(shape.gores()),
                                1.0f - uv.y / static_cast<float>(shape.panels() + 1));
    }
  }

  void place(std::size_t mesh, const glm::dmat4& transform) {
    model_.placements.push_back({mesh, transform});
  }

  const World& world_;
  Placed placed_;
  std::span<const asset::Texture> cloths_;
  asset::Model model_;
  std::map<scene::MaterialId, std::size_t> fixed_;
};

}  // namespace

asset::Model exported_model(const World& world, Placed instances,
                            std::span<const asset::Texture> cloths) {
  return Exporter(world, instances, cloths).run();
}

}  // namespace aerostat::world
