#pragma once

#include <vector>

#include "mesh/export.hpp"
#include "world/group.hpp"

namespace aerostat::world {

/// Returns the objects of an exported world, with the materials of the scene and of its models.
/// Their colours are those of plain surfaces (scene::Surfaces::plain), whatever the scene's
/// surfaces are. `triangles` is what as_triangles() returns. It must outlive the objects, and the
/// sea loses the depths that its vertices have in place of colours.
std::vector<mesh::ExportObject> exported_objects(Objects& triangles, const scene::Scene& scene,
                                                 const SceneModels& models);

}  // namespace aerostat::world
