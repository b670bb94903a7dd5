#pragma once

#include <string>

#include "scene/resolved_scene.hpp"

namespace aerostat::scene {

/// Returns as JSON what another renderer needs beside the exported triangles of a scene: the camera
/// with its axes and fields of view, the sun and the sky. Positions count from `origin`, as those
/// of the triangles do. A sky that follows from the air has no radiance in it. The text ends with a
/// line end.
std::string outside_view_text(const ResolvedScene& scene, const dvec3& origin);

}  // namespace aerostat::scene
