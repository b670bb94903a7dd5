#include "scene/materials.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace aerostat::scene {
namespace {

/// One row of the table of materials.
struct Row {
  MaterialId id;
  const char* name;
  MaterialKind kind;
  bool burner_light;  // the burners of the balloon light it
  Material coefficients;
};

Material surface(double specular, double shininess, double translucency = 0.0) {
  Material material;
  material.specular = specular;
  material.shininess = shininess;
  material.translucency = translucency;
  return material;
}

Material colored(const vec3& albedo, Material material) {
  material.albedo = albedo;
  return material;
}

/// Returns the terrain's material. Snow glitters a little, and wet leaves and sand hardly at all.
/// The albedo is that of plain ground. Chosen by eye.
Material terrain(BiomeKind biome) {
  switch (biome) {
    case BiomeKind::snow:
      return colored({0.62f, 0.63f, 0.65f}, surface(0.06, 24.0));
    case BiomeKind::tropical:
      return colored({0.06f, 0.11f, 0.03f}, surface(0.02, 12.0));
    case BiomeKind::meadow:
      return colored({0.09f, 0.13f, 0.04f}, surface(0.02, 12.0));
    case BiomeKind::sand:
      break;
  }
  return colored({0.5f, 0.32f, 0.17f}, surface(0.015, 10.0));
}

/// Returns the sea's material. The albedo is that of a plain sea. Chosen by eye.
Material water() {
  return colored({0.03f, 0.1f, 0.12f}, surface(0.6, 220.0));
}

/// Returns the material of coated ripstop nylon. It does not reflect the light that it transmits.
Material ripstop() {
  Material material = surface(0.10, 28.0, 0.3);
  material.diffuse = 0.85;
  return material;
}

/// Returns the material of a propane flame, which gives light but takes none.
Material flame() {
  Material material;
  material.ambient = 0.0;
  material.diffuse = 0.0;
  material.emission = {3.2f, 2.8f, 2.2f};
  return material;
}

const std::array<Row, kMaterialCount>& table() {
  using Id = MaterialId;
  using Kind = MaterialKind;
  static const std::array<Row, kMaterialCount> rows{{
      {Id::terrain, "terrain", Kind::ground, false, terrain(BiomeKind::sand)},
      {Id::water, "water", Kind::water, false, water()},
      {Id::envelope, "envelope", Kind::envelope, true, ripstop()},
      {Id::skirt, "skirt", Kind::skirt, true, surface(0.03, 14.0, 0.15)},  // Nomex
      {Id::basket, "basket", Kind::plain, true, surface(0.05, 18.0)},      // willow
      {Id::rim, "rim", Kind::suede, true, surface(0.03, 9.0)},             // padded
      {Id::frame, "frame", Kind::plain, true, surface(0.55, 90.0)},        // steel
      {Id::cables, "cables", Kind::plain, true, surface(0.12, 40.0)},      // steel rope
      {Id::floor, "floor", Kind::plain, true, surface(0.04, 16.0)},        // plywood
      {Id::flame, "flame", Kind::plain, false, flame()},
      {Id::plant, "plant", Kind::plain, false, surface(0.02, 12.0, 0.35)},  // leaves
      {Id::stone, "stone", Kind::plain, false, surface(0.02, 12.0)},
      {Id::track, "track", Kind::plain, false, surface(0.0, 12.0)},          // lines of flights
      {Id::passenger, "passenger", Kind::plain, true, surface(0.03, 12.0)},  // skin and cloth
  }};
  return rows;
}

const Row& row_of(MaterialId id) {
  const auto row =
      std::find_if(table().begin(), table().end(), [id](const Row& one) { return one.id == id; });
  if (row == table().end()) throw Error(ErrorKind::internal, "a material has no row");
  return *row;
}

}  // namespace

std::string material_name(MaterialId id) {
  return row_of(id).name;
}

MaterialKind material_kind(MaterialId id) {
  return row_of(id).kind;
}

bool lit_by_burners(MaterialId id) {
  return row_of(id).burner_light;
}

namespace detail {

std::array<Material, kMaterialCount> default_materials(BiomeKind biome) {
  std::array<Material, kMaterialCount> materials{};
  for (const Row& row : table()) materials[static_cast<std::size_t>(row.id)] = row.coefficients;
  materials[static_cast<std::size_t>(MaterialId::terrain)] = terrain(biome);
  return materials;
}

}  // namespace detail

}  // namespace aerostat::scene
