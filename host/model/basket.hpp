#pragma once

#include "mesh/mesh.hpp"
#include "model/detail.hpp"

namespace aerostat::model {

/// Builds the woven walls with their rope bands, the leather strip at the foot and the rope
/// handles.
mesh::TriangleMesh build_basket(const Detail& detail = {});

/// Builds the planks of plywood between the walls, and the runners under them.
mesh::TriangleMesh build_floor();

}  // namespace aerostat::model
