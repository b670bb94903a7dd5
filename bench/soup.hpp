#pragma once

#include <cstddef>
#include <memory>

#include "render/geometry.hpp"

namespace aerostat::bench {

/// A world without a terrain but a floor, such as an OBJ file might hold: a balloon among dented
/// balls and rings of many sizes, with ropes of long thin triangles through all of it; `triangles`
/// in all (give or take a part of one object), one mesh, the same in every run. Its camera stands
/// outside.
std::shared_ptr<const render::HostGeometry> build_soup(std::size_t triangles, int width,
                                                       int height);

}  // namespace aerostat::bench
