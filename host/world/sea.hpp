#pragma once

#include "world/group.hpp"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::world {

/// Returns a mesh of water as objects of a scene, without any if it is empty.
Objects water_objects(const scene::Scene& scene, mesh::TriangleMesh water);

}  // namespace aerostat::world
