#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/math.hpp"

/// The objects of a scene and the materials that they are made of.
namespace aerostat::scene {

/// The objects of a scene. The value of the enum is the `id` channel of an EXR picture, in which 0
/// is the sky. The manual lists the values.
enum class ObjectId : std::uint32_t {
  sky = 0,
  terrain,
  water,
  envelope,
  skirt,
  basket,
  rim,
  frame,
  cables,
  floor,
  flame,
  plant,
  stone,
  model,
  track,
  passenger,
  count
};
inline constexpr std::size_t kObjectCount = static_cast<std::size_t>(ObjectId::count);

/// The materials that objects are made of. The value of the enum is an index into Scene::materials.
enum class MaterialId : std::uint32_t {
  terrain,
  water,
  envelope,
  skirt,
  basket,
  rim,
  frame,
  cables,
  floor,
  flame,
  plant,
  stone,
  track,
  passenger,
  count
};
inline constexpr std::size_t kMaterialCount = static_cast<std::size_t>(MaterialId::count);

/// The kinds of materials. A kind says how the colour, the bumps and the gloss of a point are
/// found.
enum class MaterialKind { plain, ground, water, envelope, skirt, suede };

/// Phong coefficients. Most materials multiply the colours of vertices by `albedo`. Terrain and
/// water take their colours from Ground and Water, and from `albedo` only if surfaces are plain.
struct Material {
  vec3 albedo{1.0f};
  double ambient = 1.0;
  double diffuse = 1.0;
  double specular = 0.0;
  double shininess = 32.0;
  double translucency = 0.0;  // share of the light on the far side that shines through
  vec3 emission{0.0f};        // radiance, multiplied by the vertex colour
};

/// Returns the name of an object in exported meshes, such as "envelope".
std::string object_name(ObjectId id);

/// Returns the JSON key of a material, such as "envelope".
std::string material_name(MaterialId id);

/// Returns the kind of a material.
MaterialKind material_kind(MaterialId id);

/// Tells whether the burners of the balloon light a material. Their light has no shadows, so it is
/// kept to the balloon.
bool lit_by_burners(MaterialId id);

}  // namespace aerostat::scene
