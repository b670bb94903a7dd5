#pragma once

#include <cstddef>

#include "render/geometry.hpp"

namespace aerostat::bench {

/// Builds a world of one mesh, such as an OBJ file might hold, over a plain floor. A balloon
/// stands among dented balls and rings of many sizes, with ropes of long, thin triangles through
/// all of it. The mesh has `triangles` triangles and is the same in every run. The camera stands
/// outside.
render::BuiltGeometry build_soup(std::size_t triangles, int width, int height);

/// The one mesh of a soup.
const mesh::TriangleMesh& mesh_of_soup(const render::HostGeometry& geometry);

}  // namespace aerostat::bench
