#pragma once

#include "scene/json_print.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene::detail {

/// Returns the scene as JSON with every field, with keys in the order of the structs. Optional
/// values of the scene that are not given, such as a camera position, are left out.
OrderedJson to_json(const Scene& scene);

}  // namespace aerostat::scene::detail
