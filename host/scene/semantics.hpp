#pragma once

#include <string>

#include "scene/json_text.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene::detail {

/// What a schema cannot say, of a document that keeps to the schema and the scene read from it: the
/// sun given once and not as a null vector, a camera that can look, ranges in order. Throws
/// Error{bad_data}.
void check_semantics(const Json& document, const Scene& scene, const std::string& name);

}  // namespace aerostat::scene::detail
