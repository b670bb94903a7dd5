#pragma once

#include <cstddef>

#include "mesh/mesh.hpp"

namespace aerostat::plant {

/// The triangles of an outline.
inline constexpr std::size_t kOutlineTriangles = 78;

/// Returns a closed body that looks like a plant from a distance at which it is a few pixels high.
/// At every height it is as wide as the plant is, as the mean over views from the side of what is
/// covered, and has the mean colour of what is seen there. Normals point outwards and a little up,
/// as those of a crown do. So samples that meet it agree, where samples among leaves hit some leaf
/// or none. `mesh` is a plant with its foot at the origin.
mesh::TriangleMesh outline_of(const mesh::TriangleMesh& mesh);

}  // namespace aerostat::plant
