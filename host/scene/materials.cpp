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

std::array<Material, kMaterialCount> default_materials(BiomeKind biome) {
  std::array<Material, kMaterialCount> materials{};
  const auto at = [&materials](MaterialId id) -> Material& {
    return materials[static_cast<std::size_t>(id)];
  };
  at(MaterialId::terrain) = terrain(biome);
  at(MaterialId::water) = surface(vec3(1.0f), 0.6, 220.0);
  at(MaterialId::envelope) = surface(vec3(1.0f), 0.10, 28.0, 0.3);  // coated ripstop nylon
  at(MaterialId::envelope).diffuse = 0.85;  // transmitted light is not reflected
  at(MaterialId::skirt) = surface(vec3(1.0f), 0.03, 14.0, 0.15);  // Nomex, which is duller
  at(MaterialId::basket) = surface(vec3(1.0f), 0.05, 18.0);       // willow
  at(MaterialId::rim) = surface(vec3(1.0f), 0.03, 9.0);           // padded suede
  at(MaterialId::frame) = surface(vec3(1.0f), 0.55, 90.0);        // steel
  at(MaterialId::cables) = surface(vec3(1.0f), 0.12, 40.0);       // steel rope
  at(MaterialId::floor) = surface(vec3(1.0f), 0.04, 16.0);        // plywood
  at(MaterialId::flame) = flame();
  at(MaterialId::plant) = surface(vec3(1.0f), 0.02, 12.0, 0.35);  // light shines through leaves
  at(MaterialId::stone) = surface(vec3(1.0f), 0.02, 12.0);
  return materials;
}

}  // namespace aerostat::scene::detail
