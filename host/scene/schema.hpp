#pragma once

#include <string>

#include "scene/json_text.hpp"

namespace aerostat::scene::detail {

/// The text of scenes/aerostat-scene.schema.json.
extern const char* const kSchemaText;

/// The same, parsed.
const Json& schema_document();

/// Throws Error{bad_data} on the first place where the document breaks the schema; for an unknown
/// key it names those that there are, and the nearest.
void check_schema(const Json& document, const std::string& name);

}  // namespace aerostat::scene::detail
