#pragma once

#include "mesh/mesh.hpp"
#include "model/detail.hpp"

namespace aerostat::model {

/// The woven walls with their rope bands, the scuff leather at the foot and the rope handles.
mesh::TriangleMesh build_basket(const Detail& detail = {});

/// Planks of plywood between the walls, and the runners under them.
mesh::TriangleMesh build_floor();

}  // namespace aerostat::model
