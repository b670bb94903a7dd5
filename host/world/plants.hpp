#pragma once

#include "world/world.hpp"

namespace aerostat::world {

/// What grows in a resolved scene, each plant in the detail that its size in the picture asks for;
/// null if nothing does. Runs on all cores.
std::shared_ptr<const Plants> build_plants(const scene::Scene& scene, const mesh::GridMesh& ground,
                                           scatter::Where where);

/// Whether two scenes with the same land have the same plants in the same detail.
bool same_plants(const scene::Scene& a, const scene::Scene& b, scatter::Where where);

/// Appends every plant, where it stands, to a mesh of its kind of object.
void append_as_triangles(const Plants& plants, Objects& objects);

}  // namespace aerostat::world
