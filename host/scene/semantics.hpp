#pragma once

#include "scene/faults.hpp"
#include "scene/json_text.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene::detail {

/// Checks the rules that a schema cannot express, for a document that has passed the schema and
/// the scene read from it. The sun is given in one way and not as a null vector. The camera has a
/// view. Ranges are in order. All faults are added to `faults`.
void check_semantics(const Json& document, const Scene& scene, Faults& faults);

}  // namespace aerostat::scene::detail
