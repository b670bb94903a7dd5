#include "pack/pack_materials.hpp"

#include "core/error.hpp"
#include "pack/copy.hpp"
#include "trace_triangle.h"

namespace aerostat::pack {
namespace {

using scene::MaterialId;
using scene::ObjectId;

static_assert(static_cast<std::uint32_t>(MaterialId::count) == AERO_MATERIAL_COUNT);
static_assert(static_cast<std::uint32_t>(MaterialId::terrain) == AERO_GRID_MATERIAL);
static_assert(static_cast<std::uint32_t>(ObjectId::sky) == AERO_OBJECT_SKY);
static_assert(static_cast<std::uint32_t>(ObjectId::terrain) == AERO_OBJECT_TERRAIN);

/// Which code of the device works out what a material is like at a point.
std::uint32_t kind_of(MaterialId id) {
  switch (id) {
    case MaterialId::terrain:
      return AERO_MATERIAL_GROUND;
    case MaterialId::water:
      return AERO_MATERIAL_WATER;
    case MaterialId::envelope:
      return AERO_MATERIAL_ENVELOPE;
    case MaterialId::skirt:
      return AERO_MATERIAL_SKIRT;
    case MaterialId::rim:
      return AERO_MATERIAL_SUEDE;
    case MaterialId::basket:
    case MaterialId::frame:
    case MaterialId::cables:
    case MaterialId::floor:
    case MaterialId::flame:
    case MaterialId::plant:
    case MaterialId::stone:
      return AERO_MATERIAL_PLAIN;
    case MaterialId::count:
      break;
  }
  throw Error(ErrorKind::internal, "a material is out of range");
}

/// The burners cast no shadows, so that they light only what is near and in their sight.
bool lit_by_burners(MaterialId id) {
  switch (id) {
    case MaterialId::envelope:
    case MaterialId::skirt:
    case MaterialId::basket:
    case MaterialId::rim:
    case MaterialId::frame:
    case MaterialId::cables:
    case MaterialId::floor:
      return true;
    default:
      return false;
  }
}

AeroMaterial pack_material(MaterialId id, const scene::Material& from) {
  AeroMaterial material{};
  material.kind = kind_of(id);
  copy(material.albedo, from.albedo);
  material.ambient = static_cast<float>(from.ambient);
  material.diffuse = static_cast<float>(from.diffuse);
  material.specular = static_cast<float>(from.specular);
  material.shininess = static_cast<float>(from.shininess);
  material.translucency = static_cast<float>(from.translucency);
  copy(material.emission, from.emission);
  material.burner_light = lit_by_burners(id) ? 1u : 0u;
  return material;
}

}  // namespace

void pack_materials(const scene::Scene& scene, AeroMaterial (&table)[AERO_MATERIAL_COUNT]) {
  for (std::size_t i = 0; i < scene::kMaterialCount; ++i) {
    table[i] = pack_material(static_cast<MaterialId>(i), scene.materials[i]);
  }
}

}  // namespace aerostat::pack
