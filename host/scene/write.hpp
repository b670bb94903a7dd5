#pragma once

#include "scene/json_print.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene::detail {

/// The scene with every field, keys in the order of the structs. A camera position or target that
/// is not given is left out.
OrderedJson to_json(const Scene& scene);

}  // namespace aerostat::scene::detail
