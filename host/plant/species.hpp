#pragma once

#include "plant/plant.hpp"

/// Declares the builders behind plant::build. Each appends one model to an empty mesh. Its size is
/// near that of model_height, and build() then scales it to the exact height.
namespace aerostat::plant {

void build_conifer(mesh::TriangleMesh& mesh, int variant, bool snowy, Detail detail);
void build_palm(mesh::TriangleMesh& mesh, int variant, Detail detail);
void build_broadleaf(mesh::TriangleMesh& mesh, int variant, Detail detail);
void build_larch(mesh::TriangleMesh& mesh, int variant, bool golden, Detail detail);
void build_birch(mesh::TriangleMesh& mesh, int variant, bool golden, Detail detail);
void build_acacia(mesh::TriangleMesh& mesh, int variant, Detail detail);
void build_shrub(mesh::TriangleMesh& mesh, int variant, Detail detail);
void build_scrub(mesh::TriangleMesh& mesh, int variant, Detail detail);
void build_tussock(mesh::TriangleMesh& mesh, int variant, Detail detail);
void build_boulder(mesh::TriangleMesh& mesh, int variant, bool snowy, Detail detail);
void build_driftwood(mesh::TriangleMesh& mesh, int variant, Detail detail);

/// Returns the entry of a triple that belongs to a level of detail.
template <class T>
const T& at_level(const T (&levels)[3], Detail detail) {
  return levels[static_cast<int>(detail)];
}

}  // namespace aerostat::plant
