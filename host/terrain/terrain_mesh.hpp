#pragma once

#include <vector>

#include "mesh/grid_mesh.hpp"
#include "mesh/mesh.hpp"
#include "scene/land.hpp"
#include "terrain/height_field.hpp"

namespace aerostat::terrain {

/// Returns the coordinates of the grid lines along one axis. There are cells + 1 of them,
/// symmetric around 0 and spanning size_m. Cell sizes grow outwards as a geometric series. The
/// outermost cell is `grading` times as wide as the innermost. Throws Error{bad_data} if cells <
/// 1, size_m <= 0 or grading < 1.
std::vector<double> graded_axis(int cells, double size_m, double grading);

/// Returns the ground of a scene as a grid of cells x cells. Detail that is too fine for the
/// local cells is left out. Scree lies at the feet of walls. Normals are central differences over
/// neighbouring vertices. All cores are used, and the bits do not depend on their number. Throws
/// Error{bad_data} if cells < 1, size_m <= 0 or grading < 1.
mesh::GridMesh terrain_mesh(const scene::Terrain& terrain);

/// Returns the ground of a scene from a height field that already exists. The field must be that
/// of `terrain`.
mesh::GridMesh terrain_mesh(const scene::Terrain& terrain, const HeightField& field);

/// Returns the sea over `ground`, which must be terrain_mesh(terrain). It covers every cell that
/// has a corner at Water::level_m + 0.5 m or below, as a sheet at the level with normals up. Over
/// curved land it is curved. colors.x is the depth of water under each vertex in metres, 0 over dry
/// ground. colors.y and colors.z are 0. An island's sea continues beyond the terrain to 100 km from
/// its centre, joined edge to edge. The mesh is empty if the water is disabled.
mesh::TriangleMesh water_mesh(const scene::Terrain& terrain, const scene::Water& water,
                              const mesh::GridMesh& ground);

/// Returns the lakes and rivers of `field` over `ground`, which must be terrain_mesh(terrain,
/// field), as sheets like the sea. colors.y is 1.
mesh::TriangleMesh inland_water_mesh(const scene::Terrain& terrain, const HeightField& field,
                                     const mesh::GridMesh& ground);

}  // namespace aerostat::terrain
