#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/grid_mesh.hpp"
#include "plant/plant.hpp"
#include "scene/pixel_size.hpp"
#include "scene/scene.hpp"

/// Where plants and stones stand.
namespace aerostat::scatter {

/// A model that stands somewhere. Its foot lies on the ground.
struct Instance {
  vec3 position{0.0f};  // of the model's origin, as the ground counts
  float yaw_rad = 0.0f;
  vec2 lean{0.0f};  // x and z of the model's axis, a unit vector that points up
  float scale = 1.0f;
  vec3 tint{1.0f};  // multiplies the model's colours
  std::uint32_t model = 0;
};

/// The axes of a model in the world, scaled: a vertex v comes to
/// position + axes[0] v.x + axes[1] v.y + axes[2] v.z.
struct Axes {
  vec3 x, y, z;
};
Axes axes_of(const Instance& instance);

/// A circle in plan in which nothing grows that would reach into it.
struct KeepOut {
  dvec2 center{0.0};
  double radius_m = 0.0;
};

struct Growth {
  std::vector<plant::ModelKey> models;
  std::vector<Instance> instances;
};

/// All of what is in reach, or only where a picture of the scene can show it or the shade that it
/// gives: less work by far, and the same picture.
enum class Where { everywhere, in_sight };

/// All that grows in a resolved scene, upon `ground`, which must be its terrain_mesh. What grows
/// where follows the biome and the ground's own rules; the woods have the density of the trees
/// painted on the ground and thin out over the outer half of /vegetation/reach_m from the camera,
/// where the painted ones take over. The balloon and the camera are kept free. The same place grows
/// the same plants wherever the camera is. Runs on all cores; the bits do not depend on how many.
/// Empty if the vegetation is disabled.
Growth scatter(const scene::Scene& scene, const mesh::GridMesh& ground,
               Where where = Where::everywhere);

/// The level that suffices from `eye`: near where the plant is more than 120 pixels high, far where
/// it is less than 30.
plant::Detail detail_of(const Instance& instance, const plant::ModelKey& model, const dvec3& eye,
                        const scene::PixelSize& pixel);

}  // namespace aerostat::scatter
