#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/land_cover.hpp"
#include "mesh/grid_mesh.hpp"
#include "plant/plant.hpp"
#include "scatter/obstacle.hpp"
#include "scene/pixel_size.hpp"
#include "scene/resolved_scene.hpp"

/// Determines where plants and stones stand.
namespace aerostat::scatter {

/// A model that stands at a place, with its foot on the ground.
struct Instance {
  /// The position of the model's origin in the coordinates of the ground.
  vec3 position{0.0f};
  float yaw_rad = 0.0f;
  /// The x and z of the model's axis, which is a unit vector that points up.
  vec2 lean{0.0f};
  float scale = 1.0f;
  /// A factor for the model's colours.
  vec3 tint{1.0f};
  std::uint32_t model = 0;
};

/// The axes of a model in the world, scaled. They move a vertex v to
/// position + axes.x v.x + axes.y v.y + axes.z v.z.
struct Axes {
  vec3 x, y, z;
};
Axes axes_of(const Instance& instance);

/// A circle in plan. Nothing grows that would reach into it.
struct KeepOut {
  dvec2 center{0.0};
  double radius_m = 0.0;
};

struct Growth {
  std::vector<plant::ModelKey> models;
  /// The plants and stones. Their `model` is an index into `models`, or models.size() and the index
  /// of a species from a file in Vegetation::species.
  std::vector<Instance> instances;
};

/// The size of a model from a file that grows as a species, in units of the file. Both are above 0.
struct SpeciesModel {
  double height = 1.0;
  double width = 1.0;  // the greatest distance of two corners of its box in plan
};

/// Selects either all instances in reach, or only those that a picture of the scene can show or
/// whose shade it can show. The second way is much less work and gives the same picture.
enum class Where { everywhere, in_sight };

/// Returns the plants and stones of a scene. `ground` must be its terrain_mesh. Species
/// and places follow from the biome and the rules of the ground. The woods have the density of the
/// trees painted on the ground, and they thin out over the outer half of /vegetation/reach_m from
/// the camera, where the painted trees replace them. The obstacles and the camera are kept free. A
/// place has the same plants wherever the camera is. `species` has a model for each of the species
/// from files. It runs on all cores, and the bits do not
/// depend on their number. The result is empty if the vegetation is disabled. `cover` is the
/// land cover of the terrain, or null if it has none.
Growth scatter(const scene::ResolvedScene& scene, const mesh::GridMesh& ground,
               Where where = Where::everywhere, std::span<const Obstacle> obstacles = {},
               const CoverLookup* cover = nullptr, std::span<const SpeciesModel> species = {});

/// Returns the level of detail that suffices for `eye`: near if the plant is more than 120 pixels
/// high, middle above 30 pixels, far above 14 pixels, else outline.
plant::Detail detail_of(const Instance& instance, const plant::ModelKey& model, const dvec3& eye,
                        const scene::PixelSize& pixel);

/// Returns whether the plants around some obstacles are also those around others. It is so if each
/// obstacle stays, or hovers above all plants and stays in its square (obstacle.hpp). `ground`
/// counts from the scene's origin.
bool same_room(const scene::ResolvedScene& scene, const mesh::GridMesh& ground,
               std::span<const Obstacle> now, std::span<const Obstacle> before);

}  // namespace aerostat::scatter
