#include "pack/pack_materials.hpp"

#include "core/copy.hpp"
#include "scene/scene.hpp"
#include "trace_triangle.h"

namespace aerostat::pack {
namespace {

using scene::MaterialId;
using scene::MaterialKind;
using scene::ObjectId;

static_assert(scene::kMaterialCount <= AERO_FIXED_MATERIALS);
static_assert(static_cast<std::uint32_t>(MaterialId::terrain) == AERO_GRID_MATERIAL);
static_assert(static_cast<std::uint32_t>(ObjectId::sky) == AERO_OBJECT_SKY);
static_assert(static_cast<std::uint32_t>(ObjectId::terrain) == AERO_OBJECT_TERRAIN);

std::uint32_t number_of(MaterialKind kind) {
  switch (kind) {
    case MaterialKind::plain:
      return AERO_MATERIAL_PLAIN;
    case MaterialKind::ground:
      return AERO_MATERIAL_GROUND;
    case MaterialKind::water:
      return AERO_MATERIAL_WATER;
    case MaterialKind::envelope:
      return AERO_MATERIAL_ENVELOPE;
    case MaterialKind::skirt:
      return AERO_MATERIAL_SKIRT;
    case MaterialKind::suede:
      return AERO_MATERIAL_SUEDE;
  }
  return AERO_MATERIAL_PLAIN;
}

AeroMaterial pack_material(MaterialId id, const scene::Material& from) {
  AeroMaterial material{};
  material.kind = number_of(scene::material_kind(id));
  copy(material.albedo, from.albedo);
  material.ambient = static_cast<float>(from.ambient);
  material.diffuse = static_cast<float>(from.diffuse);
  material.specular = static_cast<float>(from.specular);
  material.shininess = static_cast<float>(from.shininess);
  material.translucency = static_cast<float>(from.translucency);
  copy(material.emission, from.emission);
  material.burner_light = scene::lit_by_burners(id) ? AERO_BURNER_LIT
                          : id == MaterialId::flame ? AERO_BURNER_FLAME
                                                    : AERO_BURNER_NOTHING;
  return material;
}

/// Returns a material of one colour that reflects light evenly.
AeroMaterial plain_material(const scene::Material& from) {
  AeroMaterial material{};
  material.kind = AERO_MATERIAL_PLAIN;
  copy(material.albedo, from.albedo);
  material.ambient = material.diffuse = material.shininess = 1.0f;
  material.burner_light = AERO_BURNER_NOTHING;
  return material;
}

}  // namespace

void pack_materials(const scene::Scene& scene, AeroMaterial (&table)[AERO_MAX_MATERIALS]) {
  for (std::size_t i = 0; i < scene::kMaterialCount; ++i) {
    table[i] = scene.surfaces == scene::Surfaces::plain
                   ? plain_material(scene.materials[i])
                   : pack_material(static_cast<MaterialId>(i), scene.materials[i]);
  }
}

}  // namespace aerostat::pack
