#pragma once

#include "mesh/mesh.hpp"
#include "scene/balloon.hpp"
#include "world/scene_models.hpp"

namespace aerostat::world {

/// Returns the cloth of an envelope whose shape is a model from a file. It stands above the mouth
/// of the usual envelope, so that skirt, cables and basket hang below it, and is turned with the
/// balloon. Its colours are those of the model's materials, textures and vertices. Positions count
/// from where the balloon's do.
mesh::TriangleMesh special_envelope(const scene::Balloon& balloon, const FileModel& model);

/// Removes the triangles of a balloon's cables that lie above its mouth, which in a usual envelope
/// lead to the parachute.
void cut_above_mouth(const scene::Balloon& balloon, mesh::TriangleMesh& cables);

/// Returns the mean colour of a model by area, of its materials, textures and vertices.
dvec3 mean_color(const FileModel& model);

}  // namespace aerostat::world
