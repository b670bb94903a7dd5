#pragma once

#include "scene/faults.hpp"
#include "scene/json_text.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene::detail {

/// What a schema cannot say, of a document that keeps to the schema and the scene read from it: the
/// sun given once and not as a null vector, a camera that can look, ranges in order. All that is
/// wrong is told.
void check_semantics(const Json& document, const Scene& scene, Faults& faults);

}  // namespace aerostat::scene::detail
