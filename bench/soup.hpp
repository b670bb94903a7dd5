#pragma once

#include <cstddef>
#include <memory>

#include "render/geometry.hpp"

namespace aerostat::bench {

/// Builds a world of one mesh, such as an OBJ file might hold, over a plain floor. A balloon
/// stands among dented balls and rings of many sizes, with ropes of long, thin triangles through
/// all of it. The mesh has `triangles` triangles and is the same in every run. The camera stands
/// outside.
std::shared_ptr<const render::HostGeometry> build_soup(std::size_t triangles, int width,
                                                       int height);

}  // namespace aerostat::bench
