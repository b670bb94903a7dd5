#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "core/math.hpp"
#include "scene/balloon.hpp"
#include "scene/resolved_scene.hpp"

/// Says which of the objects of a scene a point in the picture belongs to.
namespace aerostat::world {

struct SceneModels;

/// Returns the entry of Scene::objects that a point in the world on a model belongs to: the
/// smallest of the models that stand there alone and hold the point in their plan, else the one
/// that is strewn over the area around it. Returns nothing if there is none. The models are those
/// of the scene.
std::optional<std::size_t> object_at(const scene::Scene& scene, const SceneModels& models,
                                     const dvec3& point);

/// Returns the place in scene::all_balloons of the balloon whose envelope is nearest to a point in
/// the world, or nothing if no balloon is there. Heights of the balloons count from the sea.
std::optional<std::size_t> balloon_at(const scene::Scene& scene, const dvec3& point);

/// A place on the cloth of a usual envelope, as scene::Artwork counts it.
struct ClothPlace {
  double around_deg = 0.0;
  double height_m = 0.0;
};

/// Returns the place on the cloth that is nearest in direction and height to a point in the world.
/// The height of the balloon counts from the sea.
ClothPlace cloth_place(const scene::Balloon& balloon, const dvec3& point);

/// The greatest distance in metres along a ray at which it is looked for the ground.
inline constexpr double kMostReach_m = 200'000.0;

/// Returns the distance along a ray to where it first goes below `height`, a function of x and z,
/// or nothing within kMostReach_m. The direction is a unit vector. Steps grow with the distance, so
/// that narrow ridges far away may be missed.
std::optional<double> distance_to_ground(const dvec3& origin, const dvec3& direction,
                                         const std::function<double(double x, double z)>& height);

}  // namespace aerostat::world
