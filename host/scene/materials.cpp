#include "scene/materials.hpp"

namespace aerostat::scene::detail {

namespace {

Material surface(vec3 albedo, double specular, double shininess, double translucency = 0.0) {
  Material material;
  material.albedo = albedo;
  material.specular = specular;
  material.shininess = shininess;
  material.translucency = translucency;
  return material;
}

/// Returns the terrain's material. Snow glitters a little, and wet leaves and sand hardly at all.
/// Chosen by eye.
Material terrain(BiomeKind biome) {
  switch (biome) {
    case BiomeKind::snow:
      return surface(vec3(1.0f), 0.06, 24.0);
    case BiomeKind::tropical:
      return surface(vec3(1.0f), 0.02, 12.0);
    case BiomeKind::sand:
      break;
  }
  return surface(vec3(1.0f), 0.015, 10.0);
}

/// Returns the material of a propane flame, which gives light but takes none.
Material flame() {
  Material material;
  material.ambient = 0.0;
  material.diffuse = 0.0;
  material.emission = {3.2f, 2.8f, 2.2f};
  return material;
}

}  // namespace

std::array<Material, kObjectCount> default_materials(BiomeKind biome) {
  std::array<Material, kObjectCount> materials{};
  const auto at = [&materials](ObjectId id) -> Material& {
    return materials[static_cast<std::size_t>(id)];
  };
  at(ObjectId::terrain) = terrain(biome);
  at(ObjectId::water) = surface(vec3(1.0f), 0.6, 220.0);
  at(ObjectId::envelope) = surface(vec3(1.0f), 0.10, 28.0, 0.3);  // coated ripstop nylon
  at(ObjectId::envelope).diffuse = 0.85;  // transmitted light is not reflected
  at(ObjectId::skirt) = surface(vec3(1.0f), 0.03, 14.0, 0.15);  // Nomex, which is duller
  at(ObjectId::basket) = surface(vec3(1.0f), 0.05, 18.0);       // willow
  at(ObjectId::rim) = surface(vec3(1.0f), 0.03, 9.0);           // padded suede
  at(ObjectId::frame) = surface(vec3(1.0f), 0.55, 90.0);        // steel
  at(ObjectId::cables) = surface(vec3(1.0f), 0.12, 40.0);       // steel rope
  at(ObjectId::floor) = surface(vec3(1.0f), 0.04, 16.0);        // plywood
  at(ObjectId::flame) = flame();
  at(ObjectId::plant) = surface(vec3(1.0f), 0.02, 12.0, 0.35);  // light shines through leaves
  at(ObjectId::stone) = surface(vec3(1.0f), 0.02, 12.0);
  return materials;
}

}  // namespace aerostat::scene::detail
