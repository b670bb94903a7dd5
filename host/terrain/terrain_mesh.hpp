#pragma once

#include <vector>

#include "mesh/grid_mesh.hpp"
#include "mesh/mesh.hpp"
#include "scene/scene.hpp"
#include "terrain/height_field.hpp"

namespace aerostat::terrain {

/// Coordinates of the grid lines along one axis, cells + 1 of them, symmetric around 0 and
/// spanning size_m. Cell sizes grow outwards as a geometric series; the outermost is `grading`
/// times the innermost.
std::vector<double> graded_axis(int cells, double size_m, double grading);

/// The ground of a scene, cells x cells of them. Detail too fine for the local cells is left out;
/// scree lies at the feet of walls;
/// normals are central differences over neighbouring vertices. Runs on all cores; the bits do not
/// depend on how many. Throws Error{bad_data} if cells < 1, size_m <= 0 or grading < 1.
mesh::GridMesh terrain_mesh(const scene::Terrain& terrain);

/// The same from a field that is already there; it must be that of `terrain`.
mesh::GridMesh terrain_mesh(const scene::Terrain& terrain, const HeightField& field);

/// The sea over `ground`, which must be terrain_mesh(terrain): every cell that has a corner at
/// Water::level_m + 0.5 m or below, as a flat sheet at the level with normals up. colors.x is the
/// depth of water under each vertex in metres, 0 over dry ground; colors.y = colors.z = 0. An
/// island's sea goes on beyond the terrain to 100 km from its centre, joined edge to edge. Empty if
/// the water is disabled.
mesh::TriangleMesh water_mesh(const scene::Terrain& terrain, const scene::Water& water,
                              const mesh::GridMesh& ground);

}  // namespace aerostat::terrain
