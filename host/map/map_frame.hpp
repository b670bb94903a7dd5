#pragma once

#include <string>

#include "core/math.hpp"
#include "scene/resolved_scene.hpp"
#include "world/surface.hpp"

namespace aerostat::map {

/// Where a picture lies on the Earth, as programs for maps read it beside the picture.
struct MapFrame {
  std::string world_file;  // six numbers, a line each
  std::string crs;         // the local frame of the scene as WKT, for a .prj file
};

/// Returns the frame of a picture, or of the part of it that begins at the pixel `first`. Throws
/// Error{bad_data} if the camera is not orthographic and straight above the ground, and the errors
/// of names_in_view.
MapFrame map_frame(const scene::ResolvedScene& scene, const dvec2& first,
                   world::ReliefCache& reliefs);

}  // namespace aerostat::map
