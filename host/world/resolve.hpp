#pragma once

#include "scene/resolved_scene.hpp"
#include "world/surface.hpp"

namespace aerostat::world {

/// Fills in what a scene leaves to the land: positions above the ground become positions above the
/// sea, the basket view gets its camera, and an origin is chosen. The land of the scene is carved
/// only if a position is above the ground. Throws Error{bad_data} if a place is beyond the 1000 km
/// that a scene may ask for, or if the camera's target is its position.
scene::ResolvedScene resolve(scene::Scene scene);

/// Resolves a scene on the relief of a cache, where it is left for the build of the world.
scene::ResolvedScene resolve(scene::Scene scene, ReliefCache& reliefs);

/// Resolves a scene on a surface that is already there, which must be that of its terrain.
scene::ResolvedScene resolve(scene::Scene scene, const Surface& surface);

/// Returns the scene with its eye and target lifted, so that the eye is at least 2 m above the
/// land's mesh of at most `cells` cells a side. On another land than the one it was set up for, or
/// on a coarser mesh, the eye can be inside a mountain.
scene::ResolvedScene with_eye_unburied(const scene::ResolvedScene& scene, const Surface& surface,
                                       int cells);

}  // namespace aerostat::world
